package org.u2sa.drivers.motor;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/**
 * Maps a percentage to a servo or ESC pulse width: linear from neutral to either end, so the halves
 * may differ. Variable names are prefixed with the actuator's name.
 */
public record PulseWidth(
    @Variable(name = "MIN PULSE", unit = "us", min = 100, max = 5000, ifAbsent = 1000)
        @Description("Pulse at -100 %, or 100 % if reversed.")
        double minimumUs,
    @Variable(name = "NEUTRAL PULSE", unit = "us", min = 100, max = 5000, ifAbsent = 1500)
        @Description("Neutral pulse.")
        double neutralUs,
    @Variable(name = "MAX PULSE", unit = "us", min = 100, max = 5000, ifAbsent = 2000)
        @Description("Pulse at 100 %, or -100 % if reversed.")
        double maximumUs,
    @Variable(ifAbsentText = "false")
        @Description("Whether the device is reversed: swaps minimum and maximum.")
        boolean reversed,
    @Variable(name = "DEAD BAND", unit = "%", min = 0, max = 100, ifAbsent = 0)
        @Description("Dead band: percentages up to this are neutral.")
        double deadBandPercent) {
  private static final double FULL_PERCENT = 100.0;
  private static final double MICRO = 1.0e-6;

  /** Standard servo range: 1000, 1500 and 2000 µs. */
  public static final PulseWidth STANDARD = new PulseWidth(1000.0, 1500.0, 2000.0, false, 0.0);

  /**
   * @throws IllegalArgumentException naming all three pulses, if they are not in increasing order
   */
  public PulseWidth {
    if (!(minimumUs < neutralUs && neutralUs < maximumUs)) {
      throw new IllegalArgumentException(
          ("MIN PULSE " + minimumUs + " us, NEUTRAL PULSE " + neutralUs)
              + (" us and MAX PULSE " + maximumUs + " us must be in increasing order"));
    }
  }

  /**
   * Pulse width for a percentage [s], always within minimum…maximum.
   *
   * @param percent −100…100 [%]; clamped, NaN is neutral
   */
  public double seconds(double percent) {
    if (!(Math.abs(percent) > deadBandPercent)) { // NaN too
      return neutralS();
    }
    double share = Math.max(-1.0, Math.min(1.0, percent / FULL_PERCENT));
    double towardsMaximum = reversed ? -share : share;
    double lengthUs = towardsMaximum < 0.0 ? neutralUs - minimumUs : maximumUs - neutralUs;
    double us = neutralUs + towardsMaximum * lengthUs;
    return Math.max(minimumUs, Math.min(maximumUs, us)) * MICRO; // also bounds rounding
  }

  /** Neutral pulse width [s]. */
  public double neutralS() {
    return neutralUs * MICRO;
  }
}
