package org.u2sa.planning.avoidance;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Selects the passages that routes may use: first only those in which the vehicle can turn in place
 * or, if it cannot, those that its coarse outline fits through; if no such route leads to the goal,
 * all that it fits through. Confined to the planner's thread.
 */
final class Passages {
  private final Supplier<AvoidanceVariables> settings;
  private final BooleanSupplier turnsOnTheSpot;
  private final BooleanSupplier checksShape;
  private boolean isNarrow;

  /**
   * @param checksShape as {@link org.u2sa.planning.route.RoutePlanner#checksShape}
   */
  Passages(
      Supplier<AvoidanceVariables> settings,
      BooleanSupplier turnsOnTheSpot,
      BooleanSupplier checksShape) {
    this.settings = settings;
    this.turnsOnTheSpot = turnsOnTheSpot;
    this.checksShape = checksShape;
  }

  /** Restricts routes to wide passages: the goal changed, or a narrow one held the vehicle. */
  void widen() {
    isNarrow = false;
  }

  /** Admits narrow passages because no route was found; returns false if already admitted. */
  boolean narrow() {
    boolean exists =
        turnsOnTheSpot.getAsBoolean()
            ? settings.get().hasNarrower()
            : settings.get().stops() && checksShape.getAsBoolean();
    boolean begins = !isNarrow && exists;
    isNarrow |= begins;
    return begins;
  }

  /** Shape of the vehicle with which routes are checked. */
  BodyDiscs body() {
    return settings.get().body(isNarrow || turnsOnTheSpot.getAsBoolean());
  }

  SeenWorld.Reading reading() {
    return settings.get().reading(turnsOnTheSpot.getAsBoolean(), isNarrow);
  }
}
