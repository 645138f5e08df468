package org.u2sa.service.inbox;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;

/**
 * Recognises messages of a regular stream that were held up on their way, without comparing clocks:
 * the sender's may be wrong. A message is late by as much as its age exceeds the least age so far.
 * Ages that stay higher are accepted after a while, because then a clock was set, or another
 * program with another clock sends under the same name. Not thread-safe.
 */
public final class StreamDelay {
  private static final double ACCEPTED_AFTER_S = 10.0;
  private static final double STEADY_S = 0.6; // ages that differ by less
  private static final double PAUSE_S = 2.5; // of a steady stream
  private static final double DRIFT = 1e-4; // of two clocks

  /** For how long ages have stayed near the first one. */
  private static final class Level {
    private final double withinS;
    private final double pauseS;
    private double sinceS;
    private double lastS;
    private double ageS = Double.NaN;

    Level(double withinS, double pauseS) {
      this.withinS = withinS;
      this.pauseS = pauseS;
    }

    double lastsS(double nextAgeS, double nowS) {
      if (!(Math.abs(nextAgeS - ageS) <= withinS) || nowS - lastS > pauseS) {
        ageS = nextAgeS;
        sinceS = nowS;
      }
      lastS = nowS;
      return nowS - sinceS;
    }
  }

  private final double steadyAfterS; // infinite: never
  private boolean isBegun;
  private double leastS; // by two clocks, so it may be negative
  private double nowS; // of the newest message
  private Level rough; // of late messages; null before the first
  private final Level steady = new Level(STEADY_S, PAUSE_S);

  /** Accepts higher ages after 10 s. */
  public StreamDelay() {
    this(Double.POSITIVE_INFINITY);
  }

  /**
   * Also accepts higher ages that stay the same: messages that come as regularly as they were sent
   * are not a backlog. They may come beside those of another program that sends under the same
   * name.
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
    rough = null;
    return false;
  }

  private boolean staysHigher(double ageS, double limitS) {
    rough = rough == null ? new Level(limitS, Double.POSITIVE_INFINITY) : rough;
    double roughS = rough.lastsS(ageS, nowS);
    double steadyS = steady.lastsS(ageS, nowS);
    return roughS >= ACCEPTED_AFTER_S || steadyS >= steadyAfterS;
  }
}
