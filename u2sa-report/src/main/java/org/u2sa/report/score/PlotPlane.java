package org.u2sa.report.score;

import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import net.sf.geographiclib.GeodesicMask;

/**
 * Azimuthal equidistant projection about a point of the WGS-84 ellipsoid: distances and bearings
 * from that point are exact, and geodesics through it are straight. The cross-track error 10 km
 * away is d³/6R², less than a centimetre.
 */
public record PlotPlane(double longitudeDeg, double latitudeDeg) {

  /** A point of the plane, east and north of its centre [m]. */
  public record Place(double eastM, double northM) {

    double distanceM() {
      return Math.hypot(eastM, northM);
    }

    /** Linear interpolation by {@code s} (0…1) to {@code other}. */
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
