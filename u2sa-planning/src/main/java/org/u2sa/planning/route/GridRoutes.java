package org.u2sa.planning.route;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.DStarLite;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.GridPath;
import org.u2sa.planning.search.ThetaStar;

/**
 * The planners GRID and THETA, for vehicles that turn in place or need little room to turn: paths
 * through the cost grid. GRID repairs the previous path ({@link DStarLite}), THETA searches
 * any-angle paths from scratch ({@link ThetaStar}).
 */
final class GridRoutes implements RoutePlanner {
  private interface Search {
    Optional<GridPath> plan(CostGrid grid, int from, double goalNorthM, double goalEastM);
  }

  private final Search search;

  private GridRoutes(Search search) {
    this.search = search;
  }

  static GridRoutes repaired() {
    return new GridRoutes(new Repaired());
  }

  static GridRoutes fromScratch() {
    return new GridRoutes(new ThetaStar()::plan);
  }

  private static final class Repaired implements Search {
    private DStarLite search;

    @Override
    public Optional<GridPath> plan(CostGrid grid, int from, double north, double east) {
      if (search == null || !search.isFor(grid, north, east)) {
        search = new DStarLite(grid, north, east);
      }
      return search.plan(from);
    }
  }

  @Override
  public Route plan(RouteRequest request) {
    CostGrid costs = request.costs();
    GridFrame frame = costs.frame();
    Pose start = request.start();
    int from = Entrances.start(costs, start, request.mobility().body());
    if (from < 0) {
      return Route.none(Entrances.ENCLOSED);
    }
    double goalNorth = request.goalNorthM();
    double goalEast = request.goalEastM();
    if (frame.contains(goalNorth, goalEast)) {
      int goal =
          costs.nearestFreeTowards(
              goalNorth, goalEast, request.toleranceM(), start.northM(), start.eastM());
      if (goal < 0) {
        return Route.none(Entrances.GOAL_OCCUPIED);
      }
      if (!costs.isFree(frame.indexAt(goalNorth, goalEast))) {
        goalNorth = frame.centreNorthM(goal);
        goalEast = frame.centreEastM(goal);
      }
    }
    Optional<GridPath> path = search.plan(costs, from, goalNorth, goalEast);
    return path.isEmpty()
        ? Route.none(Entrances.NO_WAY)
        : route(path.get(), request, goalNorth, goalEast);
  }

  private static Route route(
      GridPath path, RouteRequest request, double goalNorth, double goalEast) {
    List<Route.Point> points = new ArrayList<>();
    points.add(new Route.Point(request.start().northM(), request.start().eastM(), false));
    // The first corner is the centre of the vehicle's own cell; do not drive back to it.
    List<GridPath.Corner> corners = path.corners();
    boolean escapes =
        request.start().distanceM(corners.get(0).northM(), corners.get(0).eastM())
            > request.costs().frame().cellM();
    for (int i = escapes ? 0 : 1; i < corners.size(); i++) {
      points.add(new Route.Point(corners.get(i).northM(), corners.get(i).eastM(), false));
    }
    boolean inside = request.costs().frame().contains(goalNorth, goalEast);
    if (inside && points.size() > 1) {
      points.remove(points.size() - 1); // the centre of the goal's cell
    }
    points.add(new Route.Point(goalNorth, goalEast, false));
    return Route.of(points, path.cost());
  }

  /** Start cells of paths through a grid, and the planners' messages if no start is free. */
  static final class Entrances {
    static final String ENCLOSED = "the vehicle is enclosed by obstacles";
    static final String GOAL_OCCUPIED = "the goal is occupied by an obstacle";
    static final String NO_WAY = "obstacles leave no way to the goal";
    static final String NONE_FOUND = "no way to the goal was found among the obstacles";

    /** Maximum start distance of a path if the vehicle is too close to an obstacle [radii]. */
    private static final double ESCAPE_RADII = 2.0;

    private Entrances() {}

    /**
     * Start cell of a path: the vehicle's own or the nearest free one to which it fits; −1 if none.
     */
    static int start(CostGrid costs, Pose start, BodyDiscs body) {
      double within =
          Math.max(ESCAPE_RADII * costs.inflation().radiusM(), 2.0 * costs.frame().cellM());
      return costs.nearestWayOut(start.northM(), start.eastM(), within, body.halfWidthM());
    }
  }
}
