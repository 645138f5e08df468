package org.u2sa.report.score;

import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import net.sf.geographiclib.GeodesicMask;

/**
 * A plane that touches the WGS-84 ellipsoid at one point: azimuthal equidistant projection, so
 * distances and bearings from that point are exact, and geodesics through it are straight. Across
 * the track, 10 km away, the error is d³/6R², less than a centimetre.
 */
public record PlotPlane(double longitudeDeg, double latitudeDeg) {

  /** A point of the plane [m] east and north of its centre. */
  public record Place(double eastM, double northM) {

    double distanceM() {
      return Math.hypot(eastM, northM);
    }

    /** The point at share {@code s} (0…1) of the way to {@code other}. */
    Place towards(Place other, double s) {
      return new Place(eastM + s * (other.eastM - eastM), northM + s * (other.northM - northM));
    }
  }

  public PlotPlane(RunPlan.Waypoint waypoint) {
    this(waypoint.longitudeDeg(), waypoint.latitudeDeg());
  }

  public Place place(double longitude, double latitude) {
    GeodesicData line =
        Geodesic.WGS84.Inverse(
            latitudeDeg,
            longitudeDeg,
            latitude,
            longitude,
            GeodesicMask.DISTANCE | GeodesicMask.AZIMUTH);
    double bearing = Math.toRadians(line.azi1);
    return new Place(line.s12 * Math.sin(bearing), line.s12 * Math.cos(bearing));
  }

  public Place place(TrackSample sample) {
    return place(sample.longitudeDeg(), sample.latitudeDeg());
  }

  public Place place(RunPlan.Waypoint waypoint) {
    return place(waypoint.longitudeDeg(), waypoint.latitudeDeg());
  }
}
