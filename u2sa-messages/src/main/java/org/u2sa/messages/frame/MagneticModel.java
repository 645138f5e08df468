package org.u2sa.messages.frame;

/**
 * Magnetic declination by the World Magnetic Model 2025 of NOAA's National Centers for
 * Environmental Information and the British Geological Survey, valid from 2025.0 to 2030.0.
 *
 * <p>Models the core field only, not the iron of vehicles, bridges or the ground.
 */
public final class MagneticModel {
  /** Start of the model's validity [decimal year]. */
  public static final double FIRST_YEAR = 2025.0;

  /** End of the model's validity [decimal year]. */
  public static final double LAST_YEAR = 2030.0;

  // World Geodetic System 1984
  private static final double EQUATOR_KM = 6378.137;
  private static final double FLATTENING = 1.0 / 298.257223563;
  private static final double ECCENTRICITY_2 = FLATTENING * (2.0 - FLATTENING);
  private static final double MIN_COSINE = 1e-10; // directions are undefined at the poles
  private static final double METRES_PER_KM = 1000.0;

  private MagneticModel() {}

  /**
   * Declination: angle of magnetic north clockwise (east) of true north [rad], −π…π; true heading =
   * magnetic heading + declination. Of little use within 2000 km of a magnetic pole, where
   * compasses do not work.
   *
   * @param latitudeDeg WGS 84 [deg], −90…90
   * @param longitudeDeg WGS 84 [deg], east positive; any number of turns
   * @param altitudeM height above the ellipsoid [m]; altitude above mean sea level is accurate
   *     enough
   * @param decimalYear for example 2027.5; clamped to {@link #FIRST_YEAR} and {@link #LAST_YEAR},
   *     for example for a vehicle whose clock was never set
   * @throws IllegalArgumentException if an argument is NaN, or the latitude is out of range
   */
  public static double declinationRad(
      double latitudeDeg, double longitudeDeg, double altitudeM, double decimalYear) {
    if (!(Math.abs(latitudeDeg) <= 90.0)) {
      throw new IllegalArgumentException("latitude: " + latitudeDeg + " is outside -90…90 deg");
    }
    if (!Double.isFinite(longitudeDeg + altitudeM) || Double.isNaN(decimalYear)) {
      throw new IllegalArgumentException(
          String.format(
              "longitude %s, altitude %s, year %s: not numbers",
              longitudeDeg, altitudeM, decimalYear));
    }
    double year = Math.max(FIRST_YEAR, Math.min(LAST_YEAR, decimalYear));
    double latitude = Math.toRadians(latitudeDeg);
    double altitudeKm = altitudeM / METRES_PER_KM;
    // geodetic to geocentric spherical coordinates (WMM2025 report, eq. 7 and 8)
    double sine = Math.sin(latitude);
    double curvatureKm = EQUATOR_KM / Math.sqrt(1.0 - ECCENTRICITY_2 * sine * sine);
    double axisKm = (curvatureKm + altitudeKm) * Math.cos(latitude);
    double upKm = (curvatureKm * (1.0 - ECCENTRICITY_2) + altitudeKm) * sine;
    double radiusKm = Math.hypot(axisKm, upKm);
    double geocentricSine = upKm / radiusKm;
    double geocentricCosine = Math.max(MIN_COSINE, axisKm / radiusKm);
    double[] field =
        WmmCoefficients.held()
            .field(
                year - FIRST_YEAR,
                radiusKm,
                geocentricSine,
                geocentricCosine,
                Math.toRadians(longitudeDeg));
    double turn = Math.atan2(geocentricSine, geocentricCosine) - latitude;
    double north = field[0] * Math.cos(turn) - field[2] * Math.sin(turn); // eq. 17
    return Math.atan2(field[1], north); // eq. 19
  }
}
