package org.u2sa.sim.ioio;

/**
 * Pulses that repeat, as a servo, a motor controller or a radio receiver knows them.
 *
 * @param widthS time that each pulse is high [s], 0 if the line is low all the time
 * @param periodS time from one rising edge to the next [s], 0 if there are none
 */
public record PulseTrain(double widthS, double periodS) {
  /** A line without pulses. */
  public static final PulseTrain NONE = new PulseTrain(0.0, 0.0);

  /**
   * Checks both times.
   *
   * @throws IllegalArgumentException unless 0 ≤ width ≤ period
   */
  public PulseTrain {
    if (!(widthS >= 0.0 && widthS <= periodS && Double.isFinite(periodS))) {
      throw new IllegalArgumentException(
          "pulses: width "
              + widthS
              + " s of period "
              + periodS
              + " s: expected 0 ≤ width ≤ period");
    }
  }

  /** Whether there are edges to count: a line that is always low, or always high, has none. */
  public boolean present() {
    return widthS > 0.0 && widthS < periodS;
  }
}
