package org.u2sa.planning.route;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.planning.curve.Curve;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.hybrid.HybridAStar;
import org.u2sa.planning.route.GridRoutes.Entrances;
import org.u2sa.planning.route.RouteRequest.Mobility;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;

/**
 * The planner HYBRID, for ground vehicles and aircraft with a turning circle: drivable paths
 * through the cost grid ({@link HybridAStar}). A search that exceeds the effort of one request
 * continues with the next one as long as vehicle and goal do not move.
 */
final class HybridRoutes implements RoutePlanner {
  /** Turn radius assumed for vehicles that turn in place [cells]. */
  private static final double MIN_RADIUS_CELLS = 2.0;

  /** Larger movements of the vehicle restart the search [cells, rad]. */
  private static final double MOVED_CELLS = 2.0;

  private static final double TURNED_RAD = Math.toRadians(5.0);

  /**
   * Paths end within this fraction of the tolerance; the goal may move by the rest during the
   * search.
   */
  private static final double GOAL_SHARE = 0.7;

  /** The same if an obstacle occupies most of that, such as the object that is the goal. */
  private static final double OCCUPIED_GOAL_SHARE = 0.95;

  /** Free ring that the smaller fraction must leave around an obstacle [cells]. */
  private static final double RING_CELLS = 2.0;

  private final HybridAStar search = new HybridAStar();
  private RouteRequest begun; // request of the search in progress; null if none

  @Override
  public Route plan(RouteRequest request) {
    CostGrid costs = request.costs();
    GridFrame frame = costs.frame();
    boolean inside = frame.contains(request.goalNorthM(), request.goalEastM());
    if (inside
        && costs.nearestFree(request.goalNorthM(), request.goalEastM(), request.toleranceM()) < 0) {
      return Route.none(Entrances.GOAL_OCCUPIED);
    }
    if (!goesOn(request)) {
      begin(request);
    }
    if (!search.search(request.effort())) {
      return Route.sought();
    }
    begun = null;
    Optional<HybridAStar.Way> way = search.found();
    if (way.isEmpty()) {
      return Route.none(search.isExhausted() ? Entrances.NONE_FOUND : Entrances.NO_WAY);
    }
    List<Route.Point> points = new ArrayList<>();
    Pose start = way.get().start();
    points.add(new Route.Point(start.northM(), start.eastM(), false));
    for (Curve.Sample sample : way.get().samples()) {
      points.add(
          new Route.Point(sample.pose().northM(), sample.pose().eastM(), sample.backwards()));
    }
    if (!inside) {
      points.add(new Route.Point(request.goalNorthM(), request.goalEastM(), false));
    }
    return Route.of(points, way.get().cost());
  }

  @Override
  public boolean checksShape() {
    return true;
  }

  private void begin(RouteRequest request) {
    begun = request;
    Mobility can = request.mobility();
    double cell = request.costs().frame().cellM();
    search.begin(
        request.costs(),
        can.body(),
        can.clearanceM(),
        HybridAStar.Motion.of(Math.max(can.turnRadiusM(), MIN_RADIUS_CELLS * cell), can.reverses()),
        request.start(),
        new HybridAStar.Goal(
            request.goalNorthM(),
            request.goalEastM(),
            request.goalHeadingRad(),
            goalShare(request) * request.toleranceM()));
  }

  private static double goalShare(RouteRequest request) {
    CostGrid costs = request.costs();
    double north = request.goalNorthM();
    double east = request.goalEastM();
    GridFrame frame = costs.frame();
    if (!frame.contains(north, east) || costs.isFree(frame.indexAt(north, east))) {
      return GOAL_SHARE;
    }
    double ring = RING_CELLS * frame.cellM();
    boolean leavesRing =
        costs.nearestFree(north, east, GOAL_SHARE * request.toleranceM() - ring) >= 0;
    return leavesRing ? GOAL_SHARE : OCCUPIED_GOAL_SHARE;
  }

  private boolean goesOn(RouteRequest now) {
    if (begun == null || begun.costs() != now.costs()) {
      return false;
    }
    double cell = now.costs().frame().cellM();
    Mobility can = now.mobility();
    Mobility could = begun.mobility();
    double turned = Pose.wrapped(now.start().headingRad() - begun.start().headingRad());
    return now.start().distanceM(begun.start().northM(), begun.start().eastM())
            <= MOVED_CELLS * cell
        && Math.abs(turned) <= TURNED_RAD
        && Math.hypot(now.goalNorthM() - begun.goalNorthM(), now.goalEastM() - begun.goalEastM())
            <= (1.0 - GOAL_SHARE) * now.toleranceM()
        && now.goalHeadingRad().equals(begun.goalHeadingRad())
        && now.toleranceM() == begun.toleranceM()
        && can.turnRadiusM() == could.turnRadiusM()
        && can.clearanceM() == could.clearanceM()
        && can.reverses() == could.reverses();
  }
}
