package org.u2sa.planning.route;

/**
 * Finds a path around obstacles. Extensions supply their own through a {@link
 * RoutePlannerProvider}. Not thread-safe.
 */
public interface RoutePlanner {
  /** Plans a path to the goal, or gives the reason why there is none. */
  Route plan(RouteRequest request);

  /**
   * Whether routes are checked with the vehicle's shape and heading, so that obstacles in the costs
   * may be inflated by half of its width only.
   */
  default boolean checksShape() {
    return false;
  }
}
