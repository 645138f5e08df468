package org.u2sa.device;

import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;

/**
 * Limits the slew rate of a percentage to protect gearboxes and batteries; one per motor. Not
 * thread-safe.
 */
public final class SlewLimit {
  private static final double FULL_PERCENT = 100.0;

  private final double percentPerS;
  private double percent;
  private long atMicros;
  private boolean hasBegun;

  /**
   * Starts at 0 %.
   *
   * @param percentPerS slew-rate limit [%/s]; infinite for none
   * @throws BadInputException if it is not positive
   */
  public SlewLimit(double percentPerS) {
    if (!(percentPerS > 0.0)) {
      throw new BadInputException("slew limit: " + percentPerS + " %/s is not positive");
    }
    this.percentPerS = percentPerS;
  }

  /**
   * Moves one step toward a percentage, and returns the percentage to apply now.
   *
   * @param target target [%], clamped to −100…100; NaN counts as 0
   * @param nowMicros time of the run's clock [µs]; the first step only starts the timer
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

  /** Drops to 0 % immediately, because stops are not limited. */
  public void rest(long nowMicros) {
    percent = 0.0;
    began(nowMicros);
  }

  /** Current value [%]. */
  public double percent() {
    return percent;
  }

  /**
   * Starts from the value of another limiter [%] (bumpless transfer); the next step starts the
   * timer.
   */
  public void goOnFrom(double held) {
    percent = held;
    hasBegun = false;
  }

  private void began(long nowMicros) {
    hasBegun = true;
    atMicros = nowMicros;
  }
}
