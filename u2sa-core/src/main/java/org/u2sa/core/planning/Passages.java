package org.u2sa.core.planning;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.core.planning.seen.SeenWorld;

/**
 * How narrow the passages are that routes lead through: first only those in which the vehicle can
 * turn on the spot; if there is no such route to the goal, all that it fits through. Belongs to the
 * planner's thread.
 */
final class Passages {
  private final Supplier<AvoidanceSettings> settings;
  private final BooleanSupplier turnsOnTheSpot;
  private boolean isNarrow;
  private SeenWorld.Reading reading; // by these settings
  private AvoidanceSettings readBy;
  private boolean isReadOnTheSpot;
  private boolean isReadNarrow;

  /**
   * @param turnsOnTheSpot whether the vehicle does
   */
  Passages(Supplier<AvoidanceSettings> settings, BooleanSupplier turnsOnTheSpot) {
    this.settings = settings;
    this.turnsOnTheSpot = turnsOnTheSpot;
  }

  /**
   * Routes lead through wide passages only: the goal is another, or it got stuck in a narrow one.
   */
  void widen() {
    isNarrow = false;
  }

  /** There is no route: narrow ones count from now on. Returns false if they do already. */
  boolean narrow() {
    boolean begins = !isNarrow && settings.get().hasNarrower(turnsOnTheSpot.getAsBoolean());
    isNarrow |= begins;
    return begins;
  }

  /** How the surroundings are read: worked out again only when something has changed. */
  SeenWorld.Reading reading() {
    AvoidanceSettings now = settings.get();
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
