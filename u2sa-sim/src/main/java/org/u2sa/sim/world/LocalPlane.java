package org.u2sa.sim.world;

import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * The local tangent plane of a simulated world and its location on earth. Within 2 km of the
 * origin, distances are accurate to a millimetre. North is the origin's; it differs from local
 * north by easting · tan(latitude) / earth radius: 0.02° at 2 km and 50° latitude.
 *
 * @param origin position of the plane's origin
 */
public record LocalPlane(Geodetic origin) {

  /**
   * Geographic position of a point on or above the plane; its altitude is the origin's plus {@code
   * upM}.
   */
  public Geodetic at(double eastM, double northM, double upM) {
    Geodetic onTangent = origin.fromEnu(Point.of(eastM, northM, 0.0));
    return new Geodetic(
        onTangent.longitudeDeg(), onTangent.latitudeDeg(), origin.altitudeM() + upM);
  }

  /** Local point of a geographic position: the inverse of {@link #at}. */
  public Point point(Geodetic place) {
    Point enu =
        origin.enuOf(new Geodetic(place.longitudeDeg(), place.latitudeDeg(), origin.altitudeM()));
    return Point.of(enu.x(), enu.y(), place.altitudeM() - origin.altitudeM());
  }
}
