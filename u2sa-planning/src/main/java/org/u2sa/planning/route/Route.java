package org.u2sa.planning.route;

import java.util.List;

/**
 * A path to the goal, or the reason why there is none. Immutable.
 *
 * @param points path from the vehicle to the goal, as far as known; empty if none
 * @param cost its length [m], weighted by the local cost; infinite if none
 * @param obstacle reason for the operator why there is no path; empty if there is one
 * @param goesOn whether the search is unfinished and continues at the next request
 */
public record Route(List<Point> points, double cost, String obstacle, boolean goesOn) {
  /**
   * A point of the path.
   *
   * @param northM on the planning plane [m]
   * @param eastM on the planning plane [m]
   * @param backwards whether the vehicle reverses to it
   */
  public record Point(double northM, double eastM, boolean backwards) {}

  public Route {
    points = List.copyOf(points);
  }

  public static Route of(List<Point> points, double cost) {
    return new Route(points, cost, "", false);
  }

  /** Creates a result without a route. */
  public static Route none(String why) {
    return new Route(List.of(), Double.POSITIVE_INFINITY, why, false);
  }

  /** Creates the result of an unfinished search that has used up its {@code effort}. */
  public static Route sought() {
    return new Route(
        List.of(), Double.POSITIVE_INFINITY, "searching for a route to the goal", true);
  }

  public boolean exists() {
    return !points.isEmpty();
  }
}
