package org.u2sa.sim.ioio;

/**
 * A repeating pulse signal, as used by servos, motor controllers and radio receivers.
 *
 * @param widthS high time of each pulse [s], 0 for a constantly low line
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

  /** Whether there are edges; constantly low or high lines have none. */
  public boolean present() {
    return widthS > 0.0 && widthS < periodS;
  }
}
