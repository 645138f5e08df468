package org.u2sa.sim.sensor;

import org.u2sa.sim.motion.Arguments;

/**
 * GNSS error parameters. Standard deviations are per axis.
 *
 * @param rateHz maximum position rate [Hz]
 * @param latencyS delay from the time of the position to its first byte [s]
 * @param whiteM white noise per position [m]
 * @param biasM Gauss-Markov bias [m]
 * @param biasTauS its time constant [s]
 * @param verticalFactor ratio of vertical to horizontal errors
 * @param velocityMps velocity noise [m/s]
 * @param betweenOutagesS mean time between outages [s], 0 for none
 * @param outageS mean duration of an outage [s]
 * @param satellites used when there is a fix
 * @param quality GGA fix quality: 1 autonomous, 4 RTK fixed
 */
public record GpsParameters(
    double rateHz,
    double latencyS,
    double whiteM,
    double biasM,
    double biasTauS,
    double verticalFactor,
    double velocityMps,
    double betweenOutagesS,
    double outageS,
    int satellites,
    int quality) {
  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public GpsParameters {
    Arguments.requireInside("GPS rate", rateHz, 0.1, 100.0);
    Arguments.requireInside("GPS latency", latencyS, 0.0, 5.0);
    Arguments.requireInside("GPS noise", whiteM, 0.0, 100.0);
    Arguments.requireInside("GPS bias", biasM, 0.0, 100.0);
    Arguments.requirePositive("time constant of the GPS bias", biasTauS);
    Arguments.requireInside("vertical factor", verticalFactor, 0.0, 10.0);
    Arguments.requireInside("GPS velocity noise", velocityMps, 0.0, 10.0);
    Arguments.requireInside("time between outages", betweenOutagesS, 0.0, 1e9);
    Arguments.requirePositive("outage", outageS);
    Arguments.requireInside("satellites", satellites, 0.0, 99.0);
    Arguments.requireInside("fix quality", quality, 1.0, 8.0);
  }

  /**
   * Survey grade: 2 cm in total, mostly white, at 10 Hz. RTK receivers specify 1 cm + 1 ppm and
   * 0.05 m/s (u-blox ZED-F9P data sheet).
   */
  public static GpsParameters survey() {
    return new GpsParameters(10.0, 0.06, 0.016, 0.012, 60.0, 1.5, 0.03, 0.0, 1.0, 16, 4);
  }

  /**
   * A phone's receiver under open sky: 3 m bias with a correlation time of two minutes, 1 Hz,
   * delayed. The thesis found such receivers too poor for its vehicle (4.6.3); smartphones in the
   * open are typically within 4.9 m, 95 % (van Diggelen and Enge 2015).
   */
  public static GpsParameters phone() {
    return new GpsParameters(1.0, 0.25, 0.5, 3.0, 120.0, 1.5, 0.15, 900.0, 5.0, 9, 1);
  }

  /** Standard deviation reported per horizontal axis [m]. */
  double horizontalSigmaM() {
    return StrictMath.sqrt(whiteM * whiteM + biasM * biasM);
  }
}
