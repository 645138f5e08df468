package org.u2sa.sim.world;

import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * The level plane of a simulated world, and where on earth it lies. Within 2 km of the origin
 * distances are those on the ground to a millimetre; north is that of the origin, which differs
 * from a place's own by its easting times the tangent of the latitude by the earth's radius: 0.02°
 * at 2 km and 50°.
 *
 * @param origin the plane's east 0, north 0, up 0
 */
public record LocalPlane(Geodetic origin) {

  /**
   * The place of a point on the plane or above it; its altitude is the origin's and {@code upM}.
   */
  public Geodetic at(double eastM, double northM, double upM) {
    Geodetic onTangent = origin.fromEnu(Point.of(eastM, northM, 0.0));
    return new Geodetic(
        onTangent.longitudeDeg(), onTangent.latitudeDeg(), origin.altitudeM() + upM);
  }

  /** A place's point on the plane or above it: the way back of {@link #at}. */
  public Point point(Geodetic place) {
    Point enu =
        origin.enuOf(new Geodetic(place.longitudeDeg(), place.latitudeDeg(), origin.altitudeM()));
    return Point.of(enu.x(), enu.y(), place.altitudeM() - origin.altitudeM());
  }
}
