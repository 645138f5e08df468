package org.u2sa.service.inbox;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;

/**
 * Recognises messages of a regular stream that were held up on their way, without comparing clocks:
 * the sender's may be wrong. A message is late by as much as its age exceeds the least age so far.
 * Ages that stay higher are accepted after a while, because then a clock was set. Not thread-safe.
 */
public final class StreamDelay {
  private static final double ACCEPTED_AFTER_S = 10.0;
  private static final double DRIFT = 1e-4; // of two clocks

  private boolean isBegun;
  private double leastS; // by two clocks, so it may be negative
  private double nowS; // of the newest message
  private boolean isLate;
  private double lateSinceS;
  private double leastLateS;

  /**
   * Takes the next message; returns whether it is late. The first one is not, nor is one without a
   * timestamp.
   *
   * @param limitS delay above which a message is late [s]; 0: never
   */
  public boolean isLate(U2SAData message, long nowMicros, double limitS) {
    if (message.timestamp().isEmpty() || limitS == 0.0) {
      return false;
    }
    double ageS = Clock.seconds(nowMicros - message.timestamp().getAsLong());
    leastS += DRIFT * (Clock.seconds(nowMicros) - nowS);
    nowS = Clock.seconds(nowMicros);
    if (!isBegun || ageS - leastS <= limitS || staysHigher(ageS, limitS)) {
      leastS = isBegun ? Math.min(leastS, ageS) : ageS;
      isBegun = true;
      isLate = false;
      return false;
    }
    return true;
  }

  private boolean staysHigher(double ageS, double limitS) {
    if (!isLate || ageS < leastLateS - limitS) {
      isLate = true;
      lateSinceS = nowS;
      leastLateS = ageS;
    }
    leastLateS = Math.min(leastLateS, ageS);
    boolean isSteady = ageS - leastLateS <= limitS;
    if (isSteady && nowS - lateSinceS >= ACCEPTED_AFTER_S) {
      leastS = leastLateS;
      return true;
    }
    return false;
  }
}
