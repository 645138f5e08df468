package org.u2sa.planning.route;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.ServiceLoader;
import org.u2sa.interfaces.configuration.Configurator;

/** All route planners: the built-in ones and those of extensions. */
public final class RoutePlanners {
  private RoutePlanners() {}

  /** Creates planners, by their value of the variable PLANNER, in display order. */
  public static Map<String, RoutePlanner> all(Configurator configuration) {
    Map<String, RoutePlanner> planners = new LinkedHashMap<>();
    planners.put("GRID", GridRoutes.repaired());
    planners.put("THETA", GridRoutes.fromScratch());
    planners.put("HYBRID", new HybridRoutes());
    planners.put("AIR", new AirRoutes());
    for (RoutePlannerProvider provider : ServiceLoader.load(RoutePlannerProvider.class)) {
      planners.putIfAbsent(provider.name(), provider.planner(configuration));
    }
    return planners;
  }
}
