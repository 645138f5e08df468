package org.u2sa.sim.sensor;

/**
 * A position computed by a receiver.
 *
 * @param timeS simulated time of the position [s]
 * @param valid whether there is a fix; if not, the other values are undefined
 * @param latitudeDeg WGS-84 [°]
 * @param longitudeDeg WGS-84 [°]
 * @param altitudeM altitude above mean sea level, taken equal to the ellipsoid [m]
 * @param eastMps east velocity [m/s]
 * @param northMps north velocity [m/s]
 * @param upMps up velocity [m/s]
 * @param horizontalSigmaM standard deviation per horizontal axis, as estimated by the receiver [m]
 * @param verticalSigmaM vertical standard deviation [m]
 * @param velocitySigmaMps velocity standard deviation per axis [m/s]
 * @param satellites number of satellites used
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
