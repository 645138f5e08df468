package org.u2sa.scenarios.report;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;

/**
 * Where places of a run stand on a north-up map: one scale both ways, origin at home (or the first
 * waypoint or sample), all that is to be seen within the frame.
 */
record MapView(
    PlotPlane plane,
    Rectangle2D.Double frame,
    double pixelsPerMetre,
    double centreEastM,
    double centreNorthM) {

  private static final double MARGIN = 1.10; // of the extent

  static MapView of(RunPlan plan, List<TrackSample> track, Rectangle2D.Double frame) {
    PlotPlane plane = plane(plan, track);
    Extent extent = new Extent();
    plan.home()
        .ifPresent(
            home -> extent.include(plane.place(home.longitudeDeg(), home.latitudeDeg()), 0.0));
    plan.waypoints()
        .forEach(waypoint -> extent.include(plane.place(waypoint), waypoint.captureRadiusM()));
    track.forEach(sample -> extent.include(plane.place(sample), 0.0));
    double least = plan.domain().leastMapM();
    double width = Math.max(least, MARGIN * extent.widthM());
    double height = Math.max(least, MARGIN * extent.heightM());
    double scale = Math.min(frame.width / width, frame.height / height);
    return new MapView(plane, frame, scale, extent.centreEastM(), extent.centreNorthM());
  }

  private static PlotPlane plane(RunPlan plan, List<TrackSample> track) {
    Optional<RunPlan.Start> home = plan.home();
    if (home.isPresent()) {
      return new PlotPlane(home.get().longitudeDeg(), home.get().latitudeDeg());
    }
    if (!plan.waypoints().isEmpty()) {
      return new PlotPlane(plan.waypoints().get(0));
    }
    return track.isEmpty()
        ? new PlotPlane(0.0, 0.0)
        : new PlotPlane(track.get(0).longitudeDeg(), track.get(0).latitudeDeg());
  }

  Point2D.Double pixel(PlotPlane.Place place) {
    return new Point2D.Double(x(place.eastM()), y(place.northM()));
  }

  Point2D.Double pixel(RunPlan.Waypoint waypoint) {
    return pixel(plane.place(waypoint));
  }

  double x(double eastM) {
    return frame.x + frame.width / 2.0 + (eastM - centreEastM) * pixelsPerMetre;
  }

  double y(double northM) {
    return frame.y + frame.height / 2.0 - (northM - centreNorthM) * pixelsPerMetre;
  }

  double westM() {
    return centreEastM - widthM() / 2.0;
  }

  double southM() {
    return centreNorthM - heightM() / 2.0;
  }

  double widthM() {
    return frame.width / pixelsPerMetre;
  }

  double heightM() {
    return frame.height / pixelsPerMetre;
  }

  /** The least upright rectangle around all places. */
  private static final class Extent {
    private double west = Double.POSITIVE_INFINITY;
    private double east = Double.NEGATIVE_INFINITY;
    private double south = Double.POSITIVE_INFINITY;
    private double north = Double.NEGATIVE_INFINITY;

    void include(PlotPlane.Place place, double radiusM) {
      west = Math.min(west, place.eastM() - radiusM);
      east = Math.max(east, place.eastM() + radiusM);
      south = Math.min(south, place.northM() - radiusM);
      north = Math.max(north, place.northM() + radiusM);
    }

    double widthM() {
      return Math.max(0.0, east - west);
    }

    double heightM() {
      return Math.max(0.0, north - south);
    }

    double centreEastM() {
      return east >= west ? (east + west) / 2.0 : 0.0;
    }

    double centreNorthM() {
      return north >= south ? (north + south) / 2.0 : 0.0;
    }
  }
}
