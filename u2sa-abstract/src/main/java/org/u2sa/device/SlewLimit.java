package org.u2sa.device;

import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;

/**
 * Keeps a percentage from changing faster than gears and batteries like. It knows the last value,
 * so there is one for each motor. Not safe for several threads.
 */
public final class SlewLimit {
  private static final double FULL_PERCENT = 100.0;

  private final double percentPerS;
  private double percent;
  private long atMicros;
  private boolean hasBegun;

  /**
   * At 0 %, at rest.
   *
   * @param percentPerS fastest change [%/s], positive; infinite: none
   * @throws BadInputException if it is not positive
   */
  public SlewLimit(double percentPerS) {
    if (!(percentPerS > 0.0)) {
      throw new BadInputException("slew limit: " + percentPerS + " %/s is not positive");
    }
    this.percentPerS = percentPerS;
  }

  /**
   * One step towards a percentage.
   *
   * @param target −100…100 [%]; beyond counts as the end, not a number as 0
   * @param nowMicros time of the run's clock [µs]; the first step only starts the watch
   * @return the percentage to hold now
   */
  public double towards(double target, long nowMicros) {
    double clamped =
        Double.isNaN(target) ? 0.0 : Math.max(-FULL_PERCENT, Math.min(FULL_PERCENT, target));
    if (Double.isInfinite(percentPerS)) {
      percent = clamped;
    } else if (hasBegun) {
      double most = percentPerS * Math.max(0.0, Clock.seconds(nowMicros - atMicros));
      double left = clamped - percent;
      percent = Math.abs(left) <= most ? clamped : percent + Math.copySign(most, left);
    }
    began(nowMicros);
    return percent;
  }

  /** Falls to 0 % at once: what must stop does not wait. The next step starts from there. */
  public void rest(long nowMicros) {
    percent = 0.0;
    began(nowMicros);
  }

  /** What it holds now [%]. */
  public double percent() {
    return percent;
  }

  /** Goes on from what another limit held [%]: the next step starts the watch from there. */
  public void goOnFrom(double held) {
    percent = held;
    hasBegun = false;
  }

  private void began(long nowMicros) {
    hasBegun = true;
    atMicros = nowMicros;
  }
}
