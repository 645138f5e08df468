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
  private static final double STEADY_S = 1.0; // ages that differ by less
  private static final double DRIFT = 1e-4; // of two clocks

  /** For how long ages have stayed near the first one. */
  private static final class Level {
    private double sinceS;
    private double ageS = Double.NaN;

    double lastsS(double nextAgeS, double withinS, double nowS) {
      if (!(Math.abs(nextAgeS - ageS) <= withinS)) {
        ageS = nextAgeS;
        sinceS = nowS;
      }
      return nowS - sinceS;
    }
  }

  private final double steadyAfterS;
  private boolean isBegun;
  private double leastS; // by two clocks, so it may be negative
  private double nowS; // of the newest message
  private Level rough = new Level(); // of late messages
  private Level steady = new Level();

  /** Accepts higher ages after 10 s. */
  public StreamDelay() {
    this(ACCEPTED_AFTER_S);
  }

  /**
   * Also accepts higher ages that stay the same, within a second: messages that come as regularly
   * as they were sent are not a backlog.
   *
   * @param steadyAfterS after so long [s]
   */
  public StreamDelay(double steadyAfterS) {
    this.steadyAfterS = steadyAfterS;
  }

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
    boolean isInTime = !isBegun || ageS - leastS <= limitS;
    if (!isInTime && !staysHigher(ageS, limitS)) {
      return true;
    }
    leastS = isBegun && isInTime ? Math.min(leastS, ageS) : ageS;
    isBegun = true;
    rough = new Level();
    steady = new Level();
    return false;
  }

  private boolean staysHigher(double ageS, double limitS) {
    double roughS = rough.lastsS(ageS, limitS, nowS);
    double steadyS = steady.lastsS(ageS, STEADY_S, nowS);
    return roughS >= ACCEPTED_AFTER_S || steadyS >= steadyAfterS;
  }
}
