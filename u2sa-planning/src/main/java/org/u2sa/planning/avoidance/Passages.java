package org.u2sa.planning.avoidance;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Selects the passages that routes may use: first only those in which the vehicle can turn in
 * place; if no such route leads to the goal, all that it fits through. Confined to the planner's
 * thread.
 */
final class Passages {
  private final Supplier<AvoidanceVariables> settings;
  private final BooleanSupplier turnsOnTheSpot;
  private boolean isNarrow;

  Passages(Supplier<AvoidanceVariables> settings, BooleanSupplier turnsOnTheSpot) {
    this.settings = settings;
    this.turnsOnTheSpot = turnsOnTheSpot;
  }

  /** Restricts routes to wide passages: the goal changed, or a narrow one held the vehicle. */
  void widen() {
    isNarrow = false;
  }

  /** Admits narrow passages because no route was found; returns false if already admitted. */
  boolean narrow() {
    boolean begins = !isNarrow && settings.get().hasNarrower(turnsOnTheSpot.getAsBoolean());
    isNarrow |= begins;
    return begins;
  }

  SeenWorld.Reading reading() {
    return settings.get().reading(turnsOnTheSpot.getAsBoolean(), isNarrow);
  }
}
