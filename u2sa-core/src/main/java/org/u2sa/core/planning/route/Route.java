package org.u2sa.core.planning.route;

import java.util.List;

/**
 * A way to the goal, or why there is none. Immutable.
 *
 * @param points from where the vehicle is to the goal, or as far as it is known; empty if there is
 *     none
 * @param cost its length [m], each metre times the cost of where it lies; infinite if there is none
 * @param obstacle why there is none, as an operator reads it; empty if there is one
 * @param goesOn whether none is known yet, as the search goes on when the planner is asked again
 */
public record Route(List<Point> points, double cost, String obstacle, boolean goesOn) {
  /**
   * A point of the way.
   *
   * @param northM on the planning plane [m]
   * @param eastM on the planning plane [m]
   * @param backwards whether the vehicle goes backwards to it
   */
  public record Point(double northM, double eastM, boolean backwards) {}

  /** Copies the points. */
  public Route {
    points = List.copyOf(points);
  }

  /** A way. */
  public static Route of(List<Point> points, double cost) {
    return new Route(points, cost, "", false);
  }

  /** That there is none. */
  public static Route none(String why) {
    return new Route(List.of(), Double.POSITIVE_INFINITY, why, false);
  }

  /** That it is not known yet, as the search has come to the end of its {@code effort}. */
  public static Route sought() {
    return new Route(List.of(), Double.POSITIVE_INFINITY, "a way to the goal is sought", true);
  }

  /** Whether there is one. */
  public boolean exists() {
    return !points.isEmpty();
  }
}
