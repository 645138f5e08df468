package org.u2sa.scenarios.roboboat;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

/** The bay of a dock according to ground truth, along and across the direction of entry. */
final class Berth {
  /** Distance from the centre of a docked boat to the back wall [m]. */
  static final double WALL_M = 0.75;

  /** Length of the fingers from the back wall [m]. */
  static final double FINGERS_M = 1.0;

  /** Width of the bay [m]. */
  static final double WIDTH_M = 2.8;

  private static final double BOW_M = 0.6; // ahead of the boat's centre
  private static final double CLOSE_M = 0.2; // distance of the bow from the wall
  private static final double GONE_M = 0.5; // likewise

  private final Point wall; // north, east [m]
  private final double headingRad;
  private boolean isDocked;

  Berth(TaskSite dock) {
    headingRad = dock.headingRad();
    wall = TaskSite.at(dock.station(), headingRad, TaskSite.DOCK_WAY_M + WALL_M, 0.0);
  }

  /** Whether the boat is docked: its bow has come close to the wall and has not left since. */
  boolean isDocked(VehicleTruth boat) {
    Point bow = bow(boat);
    isDocked = isInside(bow) && bow.x() > (isDocked ? -GONE_M : -CLOSE_M);
    return isDocked;
  }

  /** Whether the bow is between the fingers. */
  boolean isEntered(VehicleTruth boat) {
    return isInside(bow(boat));
  }

  private static boolean isInside(Point bow) {
    return bow.x() > -FINGERS_M && Math.abs(bow.y()) < WIDTH_M / 2.0;
  }

  /** Distance beyond the wall, negative in front of it, and to the right of the middle [m]. */
  private Point bow(VehicleTruth boat) {
    double north = boat.position().y() + BOW_M * Math.cos(boat.headingRad()) - wall.x();
    double east = boat.position().x() + BOW_M * Math.sin(boat.headingRad()) - wall.y();
    double cos = Math.cos(headingRad);
    double sin = Math.sin(headingRad);
    return Point.of(north * cos + east * sin, east * cos - north * sin, 0.0);
  }
}
