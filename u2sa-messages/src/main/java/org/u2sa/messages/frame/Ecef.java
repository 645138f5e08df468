package org.u2sa.messages.frame;

/** Earth-centred, earth-fixed coordinates [m] on WGS-84, through which local frames are reached. */
final class Ecef {
  private static final double A = 6_378_137.0; // semi-major axis [m], NIMA TR8350.2
  private static final double F = 1.0 / 298.257223563; // flattening, NIMA TR8350.2
  private static final double E2 = F * (2.0 - F);
  private static final int MAX_STEPS = 12; // converges in four near the earth

  private Ecef() {}

  static Point of(Geodetic place) {
    double latitude = Math.toRadians(place.latitudeDeg());
    double longitude = Math.toRadians(place.longitudeDeg());
    double n = primeVertical(Math.sin(latitude));
    double fromAxis = (n + place.altitudeM()) * Math.cos(latitude);
    return Point.of(
        fromAxis * Math.cos(longitude),
        fromAxis * Math.sin(longitude),
        (n * (1.0 - E2) + place.altitudeM()) * Math.sin(latitude));
  }

  /**
   * Inverse of {@link #of}: Bowring's parametric latitude, repeated to rest (Bowring 1976, Survey
   * Review 181).
   */
  static Geodetic geodetic(Point ecef) {
    double p = Math.hypot(ecef.x(), ecef.y());
    double b = A * (1.0 - F);
    double secondE2 = E2 / (1.0 - E2);
    double beta = Math.atan2(ecef.z() * A, p * b);
    double latitude = 0.0;
    for (int step = 0; step < MAX_STEPS; step++) {
      double sin = Math.sin(beta);
      double cos = Math.cos(beta);
      double better =
          Math.atan2(ecef.z() + secondE2 * b * sin * sin * sin, p - E2 * A * cos * cos * cos);
      boolean atRest = step > 0 && Math.abs(better - latitude) < 1e-16;
      latitude = better;
      if (atRest) {
        break;
      }
      beta = Math.atan2((1.0 - F) * Math.sin(latitude), Math.cos(latitude));
    }
    double sin = Math.sin(latitude);
    // Height along the normal: exact at all latitudes, unlike p/cos(latitude) - n.
    double altitude = p * Math.cos(latitude) + ecef.z() * sin - A * Math.sqrt(1.0 - E2 * sin * sin);
    return new Geodetic(
        Math.toDegrees(Math.atan2(ecef.y(), ecef.x())), Math.toDegrees(latitude), altitude);
  }

  /** Turns earth-centred vectors into east-north-up ones at a place. */
  static Rotation toEnu(Geodetic place) {
    double latitude = Math.toRadians(place.latitudeDeg());
    double longitude = Math.toRadians(place.longitudeDeg());
    double sinLat = Math.sin(latitude);
    double cosLat = Math.cos(latitude);
    double sinLon = Math.sin(longitude);
    double cosLon = Math.cos(longitude);
    return Rotation.rows(
        -sinLon,
        cosLon,
        0.0,
        -sinLat * cosLon,
        -sinLat * sinLon,
        cosLat,
        cosLat * cosLon,
        cosLat * sinLon,
        sinLat);
  }

  private static double primeVertical(double sinLatitude) {
    return A / Math.sqrt(1.0 - E2 * sinLatitude * sinLatitude);
  }
}
