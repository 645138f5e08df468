package org.u2sa.messages.frame;

import org.locationtech.proj4j.ProjCoordinate;
import org.locationtech.proj4j.datum.Ellipsoid;
import org.locationtech.proj4j.proj.ExtendedTransverseMercatorProjection;

/**
 * Projection of one UTM zone on WGS-84, by proj4j's extended transverse Mercator: accurate to
 * micrometres far beyond the zone's edges. Not thread-safe; cheap to create per thread.
 */
public final class UtmGrid {
  private static final double STEP_DEG = 1e-4; // for derivatives: 11 m of meridian
  private static final double FALSE_NORTHING_M = 10_000_000.0;
  private static final int ZONE_DEG = 6;

  private final ReferenceFrame frame;
  private final ExtendedTransverseMercatorProjection projection =
      new ExtendedTransverseMercatorProjection();

  /**
   * Creates the projection of a UTM frame.
   *
   * @throws IllegalArgumentException if the frame is not UTM
   */
  public UtmGrid(ReferenceFrame frame) {
    if (!frame.isUtm()) {
      throw new IllegalArgumentException("expected a UTM frame, not " + frame);
    }
    this.frame = frame;
    projection.setEllipsoid(Ellipsoid.WGS84);
    projection.setUTMZone(frame.zone());
    projection.setFalseNorthing(frame.isNorth() ? 0.0 : FALSE_NORTHING_M);
    projection.initialize();
  }

  /** UTM frame of a position, including the exceptions for Norway and Svalbard. */
  public static ReferenceFrame frameAt(Geodetic place) {
    double longitude = place.longitudeDeg();
    double latitude = place.latitudeDeg();
    int zone = Math.min(60, (int) Math.floor((longitude + 180.0) / ZONE_DEG) + 1);
    if (latitude >= 56.0 && latitude < 64.0 && longitude >= 3.0 && longitude < 12.0) {
      zone = 32;
    } else if (latitude >= 72.0 && latitude < 84.0 && longitude >= 0.0 && longitude < 42.0) {
      zone = longitude < 9.0 ? 31 : longitude < 21.0 ? 33 : longitude < 33.0 ? 35 : 37;
    }
    return ReferenceFrame.utm(zone, latitude >= 0.0);
  }

  /** Converts a point in GLOBAL or UTM to GLOBAL: longitude, latitude [deg], altitude [m]. */
  public static Point global(ReferenceFrame frame, Point point) {
    return frame.isUtm() ? new UtmGrid(frame).place(point).point() : point;
  }

  /** Easting, northing [m, false origins included] and altitude. */
  public Point grid(Geodetic place) {
    ProjCoordinate grid = projected(place.longitudeDeg(), place.latitudeDeg());
    return Point.of(grid.x, grid.y, place.altitudeM());
  }

  /** Position at easting, northing and altitude. */
  public Geodetic place(Point grid) {
    ProjCoordinate geographic = new ProjCoordinate();
    projection.inverseProject(new ProjCoordinate(grid.x(), grid.y()), geographic);
    return new Geodetic(geographic.x, geographic.y, grid.z());
  }

  /**
   * Meridian convergence at a position: direction of grid north [rad, clockwise from true north],
   * positive east of the central meridian in the northern hemisphere.
   */
  public double convergenceRad(Geodetic place) {
    ProjCoordinate north = northward(place);
    return -Math.atan2(north.x, north.y);
  }

  /**
   * Scale factor at a position: grid metres per metre on the ellipsoid, 0.9996 on the central
   * meridian.
   */
  public double scale(Geodetic place) {
    ProjCoordinate north = northward(place);
    Geodetic below = new Geodetic(place.longitudeDeg(), place.latitudeDeg() - STEP_DEG, 0.0);
    Geodetic above = new Geodetic(place.longitudeDeg(), place.latitudeDeg() + STEP_DEG, 0.0);
    return Math.hypot(north.x, north.y) / below.distanceM(above);
  }

  /** Grid displacement for a small step to true north, by central difference. */
  private ProjCoordinate northward(Geodetic place) {
    ProjCoordinate above = projected(place.longitudeDeg(), place.latitudeDeg() + STEP_DEG);
    ProjCoordinate below = projected(place.longitudeDeg(), place.latitudeDeg() - STEP_DEG);
    return new ProjCoordinate(above.x - below.x, above.y - below.y);
  }

  private ProjCoordinate projected(double longitudeDeg, double latitudeDeg) {
    ProjCoordinate grid = new ProjCoordinate();
    projection.project(new ProjCoordinate(longitudeDeg, latitudeDeg), grid);
    if (!Double.isFinite(grid.x) || !Double.isFinite(grid.y)) {
      throw new IllegalArgumentException(
          String.format(
              "longitude %s deg, latitude %s deg cannot be projected onto the grid of %s",
              longitudeDeg, latitudeDeg, frame));
    }
    return grid;
  }
}
