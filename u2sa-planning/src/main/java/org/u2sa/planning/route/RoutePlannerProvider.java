package org.u2sa.planning.route;

import org.u2sa.interfaces.configuration.Configurator;

/**
 * Provides a route planner selectable by the variable PLANNER of the Path Planner; found through
 * {@link java.util.ServiceLoader}.
 */
public interface RoutePlannerProvider {
  /** Value of PLANNER that selects it, in capitals. */
  String name();

  /**
   * Creates a route planner for one Path Planner.
   *
   * @param configuration configuration of the Path Planner, in which it declares and reads
   *     variables
   */
  RoutePlanner planner(Configurator configuration);
}
