package org.u2sa.mission;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.handover.HandOver;

/**
 * The clock of time limits: runs while the vehicle is armed, or always if the arming state is
 * unknown. Not thread-safe.
 */
final class MissionTime {
  private static final long NEVER = -1;

  private long lastMicros = NEVER;
  private boolean stands;

  /**
   * Starts or stops the clock.
   *
   * @return whether it was stopped and runs again
   */
  boolean counts(boolean armed) {
    boolean resumes = stands && armed;
    stands = !armed;
    return resumes;
  }

  /** Counted time since the last call [µs]. */
  long sinceLast(long nowMicros) {
    long counted = lastMicros == NEVER || stands ? 0 : Math.max(0, nowMicros - lastMicros);
    lastMicros = nowMicros;
    return counted;
  }

  void handOver(HandOver state) {
    state.flag("TIME STANDS", stands);
    if (lastMicros != NEVER) {
      state.number("TIME", Clock.seconds(lastMicros));
    }
  }

  /** Restores the clock; the time between two Mission Managers counts. */
  void takeOver(HandOver state) {
    stands = state.flag("TIME STANDS");
    state.number("TIME").ifPresent(seconds -> lastMicros = Clock.micros(seconds));
  }
}
