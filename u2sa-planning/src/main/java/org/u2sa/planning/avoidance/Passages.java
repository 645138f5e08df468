package org.u2sa.planning.avoidance;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Selects the passages that routes may use: first only those in which the vehicle can turn in
 * place; without such a route to the goal, all that it fits through. Confined to the planner's
 * thread.
 */
final class Passages {
  private final Supplier<AvoidanceVariables> settings;
  private final BooleanSupplier turnsOnTheSpot;
  private boolean isNarrow;
  private SeenWorld.Reading reading; // for the current settings
  private AvoidanceVariables readBy;
  private boolean isReadOnTheSpot;
  private boolean isReadNarrow;

  /**
   * @param turnsOnTheSpot whether the vehicle can turn in place
   */
  Passages(Supplier<AvoidanceVariables> settings, BooleanSupplier turnsOnTheSpot) {
    this.settings = settings;
    this.turnsOnTheSpot = turnsOnTheSpot;
  }

  /**
   * Restricts routes to wide passages, because the goal changed or the vehicle got stuck in a
   * narrow one.
   */
  void widen() {
    isNarrow = false;
  }

  /** Admits narrow passages because no route was found; returns false if already admitted. */
  boolean narrow() {
    boolean begins = !isNarrow && settings.get().hasNarrower(turnsOnTheSpot.getAsBoolean());
    isNarrow |= begins;
    return begins;
  }

  /** How the world is read; recomputed only on changes. */
  SeenWorld.Reading reading() {
    AvoidanceVariables now = settings.get();
    boolean onTheSpot = turnsOnTheSpot.getAsBoolean();
    if (now != readBy || onTheSpot != isReadOnTheSpot || isNarrow != isReadNarrow) {
      readBy = now;
      isReadOnTheSpot = onTheSpot;
      isReadNarrow = isNarrow;
      reading = now.reading(onTheSpot, isNarrow);
    }
    return reading;
  }
}
