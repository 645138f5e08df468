package org.u2sa.planning;

import java.util.Collection;
import org.u2sa.interfaces.configuration.Configurator;

/**
 * Provides an extension's planner states to every {@link PathPlanner}; found through {@link
 * java.util.ServiceLoader}.
 */
public interface PlannerStateProvider {
  /**
   * Creates states for one planner.
   *
   * @param configuration configuration of the planner, in which states declare and read their own
   *     variables
   * @param surroundings what the planner knows of the vehicle's surroundings
   */
  Collection<PlannerState> plannerStates(Configurator configuration, PlannerView surroundings);
}
