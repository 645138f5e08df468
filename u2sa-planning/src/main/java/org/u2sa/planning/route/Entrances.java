package org.u2sa.planning.route;

import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.search.CostGrid;

/** Start cells of paths through a grid, and the planners' messages if there is none. */
final class Entrances {
  static final String ENCLOSED = "the vehicle is enclosed by obstacles";
  static final String GOAL_OCCUPIED = "an obstacle stands on the goal";
  static final String NO_WAY = "obstacles leave no way to the goal";
  static final String NONE_FOUND = "no way to the goal was found among the obstacles";

  /** If the vehicle is too near to an obstacle, the path may start up to this many radii away. */
  private static final double ESCAPE_RADII = 2.0;

  private Entrances() {}

  /** Start cell of a path: the vehicle's own or the nearest free one; −1 if none. */
  static int start(CostGrid costs, Pose start) {
    double within =
        Math.max(ESCAPE_RADII * costs.inflation().radiusM(), 2.0 * costs.frame().cellM());
    return costs.nearestFree(start.northM(), start.eastM(), within);
  }
}
