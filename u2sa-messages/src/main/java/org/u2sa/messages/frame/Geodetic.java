package org.u2sa.messages.frame;

import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import net.sf.geographiclib.GeodesicMask;

/**
 * A place on WGS-84. Altitude is taken as height above the ellipsoid: the geoid's undulation is
 * left out, which shifts a whole local frame up or down but changes no difference within it.
 *
 * @param longitudeDeg east positive [deg, -180…180]
 * @param latitudeDeg north positive [deg, -90…90]
 * @param altitudeM up positive [m]
 */
public record Geodetic(double longitudeDeg, double latitudeDeg, double altitudeM) {
  private static final double FULL_TURN_DEG = 360.0;

  /** Refuses a latitude outside ±90° and anything not finite; wraps the longitude into -180…180. */
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

  /** The place of a point written in GLOBAL: x longitude, y latitude [deg], z altitude [m]. */
  public static Geodetic of(Point global) {
    return new Geodetic(global.x(), global.y(), global.z());
  }

  /** This place as a point in GLOBAL. */
  public Point point() {
    return Point.of(longitudeDeg, latitudeDeg, altitudeM);
  }

  /**
   * Where {@code other} is, seen from here: east, north, up [m] on the plane tangent to the
   * ellipsoid here.
   */
  public Point enuOf(Geodetic other) {
    Point delta = Ecef.of(other).minus(Ecef.of(this));
    return Ecef.toEnu(this).times(delta);
  }

  /** Where {@code other} is, seen from here: north, east, down [m]. */
  public Point nedOf(Geodetic other) {
    Point enu = enuOf(other);
    return Point.of(enu.y(), enu.x(), -enu.z());
  }

  /** The place at a point of the tangent plane here: east, north, up [m]. */
  public Geodetic fromEnu(Point enu) {
    return Ecef.geodetic(Ecef.of(this).plus(Ecef.toEnu(this).transposed().times(enu)));
  }

  /** The place at a point of the tangent plane here: north, east, down [m]. */
  public Geodetic fromNed(Point ned) {
    return fromEnu(Point.of(ned.y(), ned.x(), -ned.z()));
  }

  /** Turns east-north-up vectors at {@code other} into east-north-up vectors here. */
  public Rotation enuRotationFrom(Geodetic other) {
    return Ecef.toEnu(this).times(Ecef.toEnu(other).transposed());
  }

  /** Length of the geodesic on the ellipsoid, altitudes left out [m] (Karney 2013). */
  public double distanceM(Geodetic other) {
    return inverse(other, GeodesicMask.DISTANCE).s12;
  }

  /**
   * Direction of the geodesic to {@code other} where it leaves here [rad, clockwise from true
   * north, 0…2π).
   */
  public double bearingRad(Geodetic other) {
    double degrees = inverse(other, GeodesicMask.AZIMUTH).azi1;
    return Math.toRadians(degrees < 0.0 ? degrees + FULL_TURN_DEG : degrees);
  }

  /** The place reached along a geodesic from here, at the same altitude. */
  public Geodetic destination(double bearingRad, double distanceM) {
    GeodesicData end =
        Geodesic.WGS84.Direct(latitudeDeg, longitudeDeg, Math.toDegrees(bearingRad), distanceM);
    return new Geodetic(end.lon2, end.lat2, altitudeM);
  }

  private GeodesicData inverse(Geodetic other, int mask) {
    return Geodesic.WGS84.Inverse(
        latitudeDeg, longitudeDeg, other.latitudeDeg, other.longitudeDeg, mask);
  }
}
