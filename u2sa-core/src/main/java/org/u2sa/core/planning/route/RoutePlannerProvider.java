package org.u2sa.core.planning.route;

import org.u2sa.interfaces.configuration.Configurator;

/**
 * Brings a planner that the variable PLANNER of the Path Planner can name; found through {@link
 * java.util.ServiceLoader}.
 */
public interface RoutePlannerProvider {
  /** The value of PLANNER that chooses it, in capitals. */
  String name();

  /**
   * A planner for one Path Planner.
   *
   * @param configuration the Path Planner's, from which it declares and reads variables
   */
  RoutePlanner planner(Configurator configuration);
}
