package org.u2sa.sim.sensor;

/**
 * A position as a receiver computed it.
 *
 * @param timeS simulated time that it is of [s]
 * @param valid whether there is a fix; without one no other number counts
 * @param latitudeDeg WGS-84 [°]
 * @param longitudeDeg WGS-84 [°]
 * @param altitudeM above mean sea level, taken as the ellipsoid [m]
 * @param eastMps [m/s]
 * @param northMps [m/s]
 * @param upMps [m/s]
 * @param horizontalSigmaM standard deviation of each horizontal axis, as the receiver estimates [m]
 * @param verticalSigmaM [m]
 * @param velocitySigmaMps of each axis [m/s]
 * @param satellites used
 * @param quality as in GGA: 0 without a fix
 */
public record GpsSample(
    double timeS,
    boolean valid,
    double latitudeDeg,
    double longitudeDeg,
    double altitudeM,
    double eastMps,
    double northMps,
    double upMps,
    double horizontalSigmaM,
    double verticalSigmaM,
    double velocitySigmaMps,
    int satellites,
    int quality) {

  /** Speed over ground [m/s]. */
  double speedMps() {
    return StrictMath.sqrt(eastMps * eastMps + northMps * northMps);
  }

  /** Course over ground, clockwise from north [°, 0…360). */
  double courseDeg() {
    double degrees = StrictMath.toDegrees(StrictMath.atan2(eastMps, northMps));
    return degrees < 0.0 ? degrees + 360.0 : degrees;
  }
}
