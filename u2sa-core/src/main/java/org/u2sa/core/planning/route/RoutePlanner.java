package org.u2sa.core.planning.route;

/**
 * Finds a way around what stands in the way. One of your own comes by a {@link
 * RoutePlannerProvider}. Belongs to one thread.
 */
public interface RoutePlanner {
  /** The way to the goal, or why there is none. */
  Route plan(RouteRequest request);
}
