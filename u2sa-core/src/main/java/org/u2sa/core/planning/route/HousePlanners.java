package org.u2sa.core.planning.route;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.ServiceLoader;
import org.u2sa.interfaces.configuration.Configurator;

/** All planners of routes: the house's own and what extensions bring. */
public final class HousePlanners {
  private HousePlanners() {}

  /** New planners by the name that the variable PLANNER gives them, in the order of a list. */
  public static Map<String, RoutePlanner> all(Configurator configuration) {
    Map<String, RoutePlanner> planners = new LinkedHashMap<>();
    planners.put("GRID", GridRoutes.repaired());
    planners.put("THETA", GridRoutes.anew());
    planners.put("HYBRID", new HybridRoutes());
    planners.put("AIR", new AirRoutes());
    for (RoutePlannerProvider provider : ServiceLoader.load(RoutePlannerProvider.class)) {
      planners.putIfAbsent(provider.name(), provider.planner(configuration));
    }
    return planners;
  }
}
