package org.u2sa.core.mission;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.HandOver;

/**
 * The time that limits count: while the vehicle is armed, or always if nobody says whether it is.
 * Belongs to one thread.
 */
final class MissionTime {
  private static final long NEVER = -1;

  private long lastMicros = NEVER;
  private boolean stands;

  /**
   * Time counts, or it stands.
   *
   * @return whether it stood until now and counts again
   */
  boolean counts(boolean armed) {
    boolean resumes = stands && armed;
    stands = !armed;
    return resumes;
  }

  /** The time that counted since this was asked last [µs]. */
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

  /** What passes between one Mission Manager and the next counts. */
  void takeOver(HandOver state) {
    stands = state.flag("TIME STANDS");
    state.number("TIME").ifPresent(seconds -> lastMicros = Clock.micros(seconds));
  }
}
