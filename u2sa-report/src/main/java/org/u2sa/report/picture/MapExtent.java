package org.u2sa.report.picture;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.report.score.PlotPlane;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.TrackSample;

/**
 * What a map shows: the run, and the fence, areas and objects around it unless the scale would
 * become much smaller.
 *
 * @param box bounding box, east and north [m]
 * @param metresPerPixel scale at which it fits, with a margin
 */
record MapExtent(Rectangle2D box, double metresPerPixel) {
  private static final double MARGIN = 1.10; // factor on the extent
  private static final double MAX_AROUND = 2.0; // factor on the scale for what lies around

  /**
   * @param outlines longitudes and latitudes of areas and objects [deg]
   * @param size of the map [px]
   */
  static MapExtent of(
      RunPlan plan,
      List<TrackSample> track,
      List<List<Point2D>> outlines,
      PlotPlane plane,
      Rectangle2D size) {
    double leastM = plan.domain().leastMapM();
    Rectangle2D extent = ofRun(plan, track, plane);
    double most = MAX_AROUND * metresPerPixel(extent, leastM, size);
    List<List<Point2D>> shapes = new ArrayList<>(outlines);
    shapes.add(corners(plan.fence()));
    plan.keepOuts().forEach(area -> shapes.add(corners(area)));
    for (List<Point2D> shape : shapes) {
      Rectangle2D larger =
          shape.stream()
              .map(at -> box(plane.place(at.getX(), at.getY()), 0.0))
              .reduce(extent, Rectangle2D::createUnion);
      extent = metresPerPixel(larger, leastM, size) <= most ? larger : extent;
    }
    return new MapExtent(extent, metresPerPixel(extent, leastM, size));
  }

  /** Bounding box of home, track and capture circles. */
  private static Rectangle2D ofRun(RunPlan plan, List<TrackSample> track, PlotPlane plane) {
    List<Rectangle2D> boxes = new ArrayList<>();
    plan.home()
        .ifPresent(home -> boxes.add(box(plane.place(home.longitudeDeg(), home.latitudeDeg()), 0)));
    plan.waypoints().forEach(w -> boxes.add(box(plane.place(w), w.captureRadiusM())));
    track.forEach(sample -> boxes.add(box(plane.place(sample), 0.0)));
    return boxes.stream().reduce(Rectangle2D::createUnion).orElse(new Rectangle2D.Double());
  }

  private static double metresPerPixel(Rectangle2D extent, double leastM, Rectangle2D size) {
    return Math.max(
        Math.max(leastM, MARGIN * extent.getWidth()) / size.getWidth(),
        Math.max(leastM, MARGIN * extent.getHeight()) / size.getHeight());
  }

  private static List<Point2D> corners(List<RunPlan.Corner> outline) {
    return outline.stream()
        .map(each -> (Point2D) new Point2D.Double(each.longitudeDeg(), each.latitudeDeg()))
        .toList();
  }

  private static Rectangle2D box(PlotPlane.Place centre, double radiusM) {
    return new Rectangle2D.Double(
        centre.eastM() - radiusM, centre.northM() - radiusM, 2.0 * radiusM, 2.0 * radiusM);
  }
}
