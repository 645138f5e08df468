package org.u2sa.drivers.rc;

import java.util.OptionalDouble;
import org.u2sa.drivers.motor.PulseWidth;

/**
 * One channel of a radio receiver as a stick. Immutable.
 *
 * @param width which pulse means which percentage
 * @param marginUs how far beyond the ends a pulse may be and still count as the end [µs]
 */
public record RcChannel(PulseWidth width, double marginUs) {
  private static final double MICRO = 1.0e-6;
  private static final double USUAL_MARGIN_US = 200.0;

  /** 1000…1500…2000 µs, and 200 µs beyond: what radios give with trims at their ends. */
  public static final RcChannel STANDARD = new RcChannel(PulseWidth.STANDARD, USUAL_MARGIN_US);

  /** Whether a pulse of this width [s] can be a receiver's; NaN cannot. */
  public boolean isValid(double pulseS) {
    double us = pulseS / MICRO;
    return us >= width.minimumUs() - marginUs && us <= width.maximumUs() + marginUs;
  }

  /**
   * Where the stick is.
   *
   * @param pulseS width of a pulse [s]
   * @return −100…100 [%]; empty if no receiver gives such a pulse
   */
  public OptionalDouble percentage(double pulseS) {
    return isValid(pulseS) ? OptionalDouble.of(width.percent(pulseS)) : OptionalDouble.empty();
  }
}
