package org.u2sa.drivers.motor;

import org.u2sa.interfaces.BadInputException;

/**
 * How a percentage becomes the width of a servo pulse, for servos and electronic speed controls.
 * Straight from neutral to either end, so that both halves may be of different length. Immutable.
 *
 * @param minimumUs shortest pulse, at −100 % [µs]
 * @param neutralUs pulse at which nothing moves [µs]
 * @param maximumUs longest pulse, at 100 % [µs]
 * @param reversed whether the device turns the wrong way: then the ends are exchanged
 * @param deadBandPercent percentages not farther from 0 than this are neutral [%], 0…100
 */
public record PulseWidth(
    double minimumUs,
    double neutralUs,
    double maximumUs,
    boolean reversed,
    double deadBandPercent) {
  private static final double FULL_PERCENT = 100.0;
  private static final double MICRO = 1.0e-6;

  /** As servos and radios have it: 1000, 1500 and 2000 µs. */
  public static final PulseWidth STANDARD = new PulseWidth(1000.0, 1500.0, 2000.0, false, 0.0);

  /**
   * Checks that minimum &lt; neutral &lt; maximum.
   *
   * @throws BadInputException naming all three, if they are not in that order
   */
  public PulseWidth {
    if (!(0.0 < minimumUs && minimumUs < neutralUs && neutralUs < maximumUs)) {
      throw new BadInputException(
          "pulse widths: "
              + minimumUs
              + " us, neutral "
              + neutralUs
              + " us, "
              + maximumUs
              + " us are not in growing order");
    }
    if (!(deadBandPercent >= 0.0 && deadBandPercent <= FULL_PERCENT)) {
      throw new BadInputException("dead band: " + deadBandPercent + " % is outside 0…100 %");
    }
  }

  /**
   * The pulse for a percentage [s], never outside minimum…maximum.
   *
   * @param percent −100…100 [%]; beyond counts as the end, not a number as neutral
   */
  public double seconds(double percent) {
    if (!(Math.abs(percent) > deadBandPercent)) { // NaN too
      return neutralS();
    }
    double share = Math.max(-1.0, Math.min(1.0, percent / FULL_PERCENT));
    double towardsMaximum = reversed ? -share : share;
    double lengthUs = towardsMaximum < 0.0 ? neutralUs - minimumUs : maximumUs - neutralUs;
    double us = neutralUs + towardsMaximum * lengthUs;
    return Math.max(minimumUs, Math.min(maximumUs, us)) * MICRO; // rounding stays within, too
  }

  /** The pulse at which nothing moves [s]. */
  public double neutralS() {
    return neutralUs * MICRO;
  }

  /**
   * The way back, for pulses that a radio receiver gives.
   *
   * @param pulseS finite [s]; beyond the ends counts as the end
   * @return −100…100 [%]; 0 inside the dead band
   */
  public double percent(double pulseS) {
    double offUs = pulseS / MICRO - neutralUs;
    double lengthUs = offUs < 0.0 ? neutralUs - minimumUs : maximumUs - neutralUs;
    double share = Math.max(-1.0, Math.min(1.0, offUs / lengthUs));
    double percent = (reversed ? -share : share) * FULL_PERCENT;
    return Math.abs(percent) > deadBandPercent ? percent : 0.0;
  }
}
