package org.u2sa.core.planning.route;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.core.planning.curve.Curve;
import org.u2sa.core.planning.hybrid.HybridAStar;
import org.u2sa.core.planning.search.CostGrid;
import org.u2sa.core.planning.search.GridFrame;

/**
 * The planner HYBRID, for vehicles with a turning circle, on wheels or in the air: ways that they
 * can follow through the grid of costs ({@link HybridAStar}).
 */
final class HybridRoutes implements RoutePlanner {
  /** A vehicle that turns on the spot is planned for as if it needed this [cells]. */
  private static final double LEAST_RADIUS_CELLS = 2.0;

  private final HybridAStar search = new HybridAStar();

  @Override
  public Route plan(RouteRequest request) {
    CostGrid costs = request.costs();
    GridFrame frame = costs.frame();
    if (frame.contains(request.goalNorthM(), request.goalEastM())
        && costs.nearestFree(request.goalNorthM(), request.goalEastM(), request.toleranceM()) < 0) {
      return Route.none(Entrances.GOAL_OCCUPIED);
    }
    Mobility can = request.mobility();
    double radius = Math.max(can.turnRadiusM(), LEAST_RADIUS_CELLS * frame.cellM());
    Optional<HybridAStar.Way> way =
        search.plan(
            costs,
            can.body(),
            can.clearanceM(),
            HybridAStar.Motion.of(radius, can.reverses()),
            request.start(),
            new HybridAStar.Goal(
                request.goalNorthM(),
                request.goalEastM(),
                request.goalHeadingRad(),
                0.7 * request.toleranceM()));
    if (way.isEmpty()) {
      return Route.none(Entrances.NO_WAY);
    }
    List<Route.Point> points = new ArrayList<>();
    points.add(new Route.Point(request.start().northM(), request.start().eastM(), false));
    for (Curve.Sample sample : way.get().samples()) {
      points.add(
          new Route.Point(sample.pose().northM(), sample.pose().eastM(), sample.backwards()));
    }
    if (!frame.contains(request.goalNorthM(), request.goalEastM())) {
      points.add(new Route.Point(request.goalNorthM(), request.goalEastM(), false));
    }
    return Route.of(points, way.get().cost());
  }
}
