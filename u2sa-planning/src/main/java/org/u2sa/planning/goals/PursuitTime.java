package org.u2sa.planning.goals;

import org.u2sa.interfaces.time.Clock;

/**
 * Time for which a goal could be pursued, against which patience with it is measured. It stands
 * still while the vehicle may not move, because it is disarmed or stopped by a failsafe, and while
 * no states arrive: a vehicle that is armed again has as much time left as before. Confined to the
 * planner's thread.
 */
public final class PursuitTime {
  private static final long LONGEST_STEP_MICROS = Clock.MICROS_PER_SECOND; // between two states

  private long micros;
  private long before = Long.MIN_VALUE; // time of the last state

  /**
   * Receives the time of a state for which a goal is pursued [µs].
   *
   * @param mayMove whether the vehicle is armed
   */
  public void see(long nowMicros, boolean mayMove) {
    if (mayMove && before != Long.MIN_VALUE) {
      micros += Math.max(0L, Math.min(LONGEST_STEP_MICROS, nowMicros - before));
    }
    before = nowMicros;
  }

  /** The time [µs], from 0. */
  public long micros() {
    return micros;
  }
}
