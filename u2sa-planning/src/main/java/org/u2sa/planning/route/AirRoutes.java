package org.u2sa.planning.route;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.planning.air.TangentGraph;
import org.u2sa.planning.curve.Curve;
import org.u2sa.planning.route.RouteRequest.Mobility;
import org.u2sa.planning.search.CostGrid;

/**
 * The planner AIR: the shortest path around cylinders and keep-out zones and inside corridors, by
 * arcs and tangents ({@link TangentGraph}). If it finds none, or an obstacle known only from the
 * grid is in the way, it plans like HYBRID.
 */
final class AirRoutes implements RoutePlanner {
  private static final double MIN_RADIUS_M = 0.1;
  private static final double ASIDE = 0.25; // longer ways [spans of the window]
  private static final double KEPT = 1.05; // margin on the clearance, to agree with grid cells

  private final RoutePlanner grids = new HybridRoutes();

  @Override
  public Route plan(RouteRequest request) {
    Mobility can = request.mobility();
    double cell = request.costs().frame().cellM();
    Optional<Curve> curve =
        TangentGraph.shortest(
            request.shapes(),
            request.corridors(),
            KEPT * (can.body().radiusM() + can.clearanceM()) + cell,
            request.start(),
            request.goalNorthM(),
            request.goalEastM(),
            request.goalHeadingRad(),
            Math.max(MIN_RADIUS_M, can.turnRadiusM()));
    if (curve.isEmpty()) {
      return grids.plan(request);
    }
    List<Route.Point> points = new ArrayList<>();
    points.add(new Route.Point(request.start().northM(), request.start().eastM(), false));
    double step = Math.max(2.0 * cell, 0.1 * can.turnRadiusM());
    for (Curve.Sample sample : curve.get().sampled(request.start(), step)) {
      points.add(new Route.Point(sample.pose().northM(), sample.pose().eastM(), false));
    }
    double cost = 0.0;
    for (int i = 1; i < points.size(); i++) {
      Route.Point from = points.get(i - 1);
      Route.Point to = points.get(i);
      double here =
          request.costs().straightCost(from.northM(), from.eastM(), to.northM(), to.eastM());
      boolean leaves =
          here == Double.POSITIVE_INFINITY
              && request.start().distanceM(to.northM(), to.eastM())
                  < 2.0 * request.costs().inflation().radiusM();
      cost += leaves ? Math.hypot(to.northM() - from.northM(), to.eastM() - from.eastM()) : here;
    }
    return cost == Double.POSITIVE_INFINITY || leadsAside(points, request)
        ? grids.plan(request)
        : Route.of(points, cost);
  }

  /**
   * Whether the path leaves the window where the way on leads around ground that is too high: it is
   * only planned around what is in the window.
   */
  private static boolean leadsAside(List<Route.Point> points, RouteRequest request) {
    CostGrid costs = request.costs();
    int exit = 0;
    while (exit < points.size()
        && costs.frame().contains(points.get(exit).northM(), points.get(exit).eastM())) {
      exit++;
    }
    if (exit == 0 || exit == points.size()) {
      return false;
    }
    double leftM = 0.0;
    for (int i = exit; i < points.size(); i++) {
      Route.Point from = points.get(i - 1);
      leftM +=
          Math.hypot(points.get(i).northM() - from.northM(), points.get(i).eastM() - from.eastM());
    }
    Route.Point from = points.get(exit - 1);
    double onM =
        costs.beyondM(from.northM(), from.eastM(), request.goalNorthM(), request.goalEastM());
    return onM > leftM + ASIDE * costs.frame().rows() * costs.frame().cellM();
  }
}
