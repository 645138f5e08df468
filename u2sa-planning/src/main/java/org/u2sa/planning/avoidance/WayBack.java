package org.u2sa.planning.avoidance;

import java.util.List;
import java.util.Optional;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanarShape;

/**
 * Closes the way back between two lines, such as those of a lane, behind a vehicle that has reached
 * a waypoint: the way ahead is not seen yet and may be longer, but leads to the next waypoint.
 */
final class WayBack {
  private static final double MARGIN_M = 1.0; // leaves room to turn and to back out

  private WayBack() {}

  /**
   * Chain from the nearest line on the left, behind the vehicle, to the nearest on the right; empty
   * unless both sides have a line.
   *
   * @param shapes static obstacles; chains among them are lines
   * @param circleM turning radius of the vehicle
   * @param reachM maximum distance of a line
   */
  static Optional<PlanarShape> closed(
      List<PlanarShape> shapes, Pose pose, double circleM, double reachM) {
    double[] left = nearest(shapes, pose, reachM, -1.0);
    double[] right = nearest(shapes, pose, reachM, 1.0);
    if (left.length == 0 || right.length == 0) {
      return Optional.empty();
    }
    Pose behind = pose.along(-circleM - MARGIN_M, 0.0);
    return Optional.of(
        PlanarShape.wall(
            "way back",
            new double[] {left[0], behind.northM(), right[0]},
            new double[] {left[1], behind.eastM(), right[1]}));
  }

  /**
   * North and east of the nearest point of a chain on one side (1: right); an empty array if none.
   */
  private static double[] nearest(List<PlanarShape> shapes, Pose pose, double reachM, double side) {
    double[] found = {};
    double least = reachM;
    for (PlanarShape shape : shapes) {
      for (int i = 0; shape.kind() == PlanarShape.Kind.CHAIN && i < shape.count(); i++) {
        double north = shape.northM(i) - pose.northM();
        double east = shape.eastM(i) - pose.eastM();
        double right = east * Math.cos(pose.headingRad()) - north * Math.sin(pose.headingRad());
        double away = Math.sqrt(north * north + east * east);
        if (side * right > 0.0 && away < least) {
          least = away;
          found = new double[] {shape.northM(i), shape.eastM(i)};
        }
      }
    }
    return found;
  }
}
