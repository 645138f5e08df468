package org.u2sa.messages.frame;

import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import net.sf.geographiclib.GeodesicMask;

/**
 * A position on WGS-84. Altitude is taken as height above the ellipsoid: geoid undulation is
 * neglected, which shifts a local frame up or down but does not affect differences within it.
 *
 * @param longitudeDeg east positive [deg, -180…180]
 * @param latitudeDeg north positive [deg, -90…90]
 * @param altitudeM up positive [m]
 */
public record Geodetic(double longitudeDeg, double latitudeDeg, double altitudeM) {
  private static final double FULL_TURN_DEG = 360.0;

  /** Rejects latitudes outside ±90° and non-finite values; wraps the longitude into -180…180. */
  public Geodetic {
    if (!Double.isFinite(longitudeDeg)) {
      throw new IllegalArgumentException(
          "longitude: " + longitudeDeg + " is not a number of degrees");
    }
    if (!(Math.abs(latitudeDeg) <= 90.0)) {
      throw new IllegalArgumentException("latitude: " + latitudeDeg + " deg is outside -90…90 deg");
    }
    if (!Double.isFinite(altitudeM)) {
      throw new IllegalArgumentException("altitude: " + altitudeM + " is not a number of metres");
    }
    if (Math.abs(longitudeDeg) > FULL_TURN_DEG / 2.0) {
      longitudeDeg = Math.IEEEremainder(longitudeDeg, FULL_TURN_DEG);
    }
  }

  /** Converts a point in GLOBAL: x longitude, y latitude [deg], z altitude [m]. */
  public static Geodetic of(Point global) {
    return new Geodetic(global.x(), global.y(), global.z());
  }

  /** This position as a point in GLOBAL. */
  public Point point() {
    return Point.of(longitudeDeg, latitudeDeg, altitudeM);
  }

  /**
   * Position of {@code other} relative to this one: east, north, up [m] in the plane tangent to the
   * ellipsoid here.
   */
  public Point enuOf(Geodetic other) {
    Point delta = Ecef.of(other).minus(Ecef.of(this));
    return Ecef.toEnu(this).times(delta);
  }

  /** Position of {@code other} relative to this one: north, east, down [m]. */
  public Point nedOf(Geodetic other) {
    Point enu = enuOf(other);
    return Point.of(enu.y(), enu.x(), -enu.z());
  }

  /** Position of a point of the tangent plane here: east, north, up [m]. */
  public Geodetic fromEnu(Point enu) {
    return Ecef.geodetic(Ecef.of(this).plus(Ecef.toEnu(this).transposed().times(enu)));
  }

  /** Position of a point of the tangent plane here: north, east, down [m]. */
  public Geodetic fromNed(Point ned) {
    return fromEnu(Point.of(ned.y(), ned.x(), -ned.z()));
  }

  /** Rotation from east-north-up at {@code other} to east-north-up here. */
  public Rotation enuRotationFrom(Geodetic other) {
    return Ecef.toEnu(this).times(Ecef.toEnu(other).transposed());
  }

  /** Geodesic distance on the ellipsoid, ignoring altitudes [m] (Karney 2013). */
  public double distanceM(Geodetic other) {
    return inverse(other, GeodesicMask.DISTANCE).s12;
  }

  /** Initial azimuth of the geodesic to {@code other} [rad, clockwise from true north, 0…2π). */
  public double bearingRad(Geodetic other) {
    double degrees = inverse(other, GeodesicMask.AZIMUTH).azi1;
    return Math.toRadians(degrees < 0.0 ? degrees + FULL_TURN_DEG : degrees);
  }

  /** Position reached along a geodesic from here, at the same altitude. */
  public Geodetic destination(double bearingRad, double distanceM) {
    GeodesicData end =
        Geodesic.WGS84.Direct(latitudeDeg, longitudeDeg, Math.toDegrees(bearingRad), distanceM);
    return new Geodetic(end.lon2, end.lat2, altitudeM);
  }

  private GeodesicData inverse(Geodetic other, int mask) {
    return Geodesic.WGS84.Inverse(
        latitudeDeg, longitudeDeg, other.latitudeDeg, other.longitudeDeg, mask);
  }

  /**
   * Earth-centred, earth-fixed coordinates [m] on WGS-84, through which local frames are reached.
   */
  private static final class Ecef {
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
     * Inverse of {@link #of}: Bowring's parametric latitude, iterated to convergence (Bowring 1976,
     * Survey Review 181).
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
      double altitude =
          p * Math.cos(latitude) + ecef.z() * sin - A * Math.sqrt(1.0 - E2 * sin * sin);
      return new Geodetic(
          Math.toDegrees(Math.atan2(ecef.y(), ecef.x())), Math.toDegrees(latitude), altitude);
    }

    /** Rotates earth-centred vectors to east-north-up axes at a position. */
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
}
