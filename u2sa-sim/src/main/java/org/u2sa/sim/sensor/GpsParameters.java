package org.u2sa.sim.sensor;

import org.u2sa.sim.motion.Arguments;

/**
 * The errors of a satellite receiver. Standard deviations are those of each axis.
 *
 * @param rateHz positions in a second, at most
 * @param latencyS from the moment that a position is of to its first byte [s]
 * @param whiteM noise of each position [m]
 * @param biasM error that wanders slowly, Gauss-Markov [m]
 * @param biasTauS its time constant [s]
 * @param verticalFactor by which vertical errors are larger than horizontal ones
 * @param velocityMps noise of the velocity [m/s]
 * @param betweenOutagesS mean time between drop-outs [s], 0 for none
 * @param outageS mean duration of a drop-out [s]
 * @param satellites used when there is a fix
 * @param quality of the fix as GGA says it: 1 autonomous, 4 RTK fixed
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
   * Survey grade: 2 cm in all, most of it white, at 10 Hz. Real-time kinematic receivers claim 1 cm
   * + 1 ppm and 0.05 m/s (u-blox ZED-F9P data sheet).
   */
  public static GpsParameters survey() {
    return new GpsParameters(10.0, 0.06, 0.016, 0.012, 60.0, 1.5, 0.03, 0.0, 1.0, 16, 4);
  }

  /**
   * A telephone's receiver under open sky: 3 m that wander over two minutes, once a second, late.
   * The thesis found such receivers too poor for its vehicle (4.6.3); smartphones in the open are
   * typically within 4.9 m, 95 % (van Diggelen and Enge 2015).
   */
  public static GpsParameters phone() {
    return new GpsParameters(1.0, 0.25, 0.5, 3.0, 120.0, 1.5, 0.15, 900.0, 5.0, 9, 1);
  }

  /**
   * A stand-alone aviation receiver without corrections: 1.5 m that wander over two minutes, 0.3 m
   * of noise, five times a second. High-quality single-frequency receivers do better: 1.9 m, 95 %
   * (gps.gov, GPS Accuracy).
   */
  public static GpsParameters aviation() {
    return new GpsParameters(5.0, 0.15, 0.3, 1.5, 120.0, 1.8, 0.1, 0.0, 1.0, 10, 1);
  }

  /** What the receiver says of each horizontal axis [m]. */
  double horizontalSigmaM() {
    return StrictMath.sqrt(whiteM * whiteM + biasM * biasM);
  }
}
