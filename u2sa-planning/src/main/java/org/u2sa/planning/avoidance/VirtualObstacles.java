package org.u2sa.planning.avoidance;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.seen.PlanarShape;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Virtual obstacles that the planner adds while another route exists: the way back, blocked gaps,
 * ground behind the vehicle that was never seen, and the wrong sides of marks. Confined to the
 * planner's thread.
 */
final class VirtualObstacles {
  private static final int CORNERS = 6; // of half a circle

  private final SeenWorld world;
  private final FalseGaps gaps = new FalseGaps();
  private final PassSides sides = new PassSides();
  private List<PlanarShape> wayBack = List.of();
  private List<PlanarShape> unseen = List.of();

  VirtualObstacles(SeenWorld world) {
    this.world = world;
  }

  /** Reopens gaps and unseen ground, because no other route exists or the goal changed. */
  void forgetGaps() {
    unseen = List.of();
    gaps.forget();
    tell();
  }

  /** Discards all of them, because the plane changed; takes effect with the next change. */
  void forgetAll() {
    wayBack = List.of();
    unseen = List.of();
    gaps.forget();
    sides.forget();
  }

  /** Blocks the way back, up to a distance to each side. */
  void closeBehind(Pose pose, double circleM, double mostM) {
    wayBack = WayBack.closed(world.shapes(), pose, circleM, mostM).map(List::of).orElse(List.of());
    tell();
  }

  /** Blocks ground behind the vehicle that was never seen: half a circle about it. */
  void closeUnseen(Pose pose, double radiusM) {
    double[] norths = new double[CORNERS + 1];
    double[] easts = new double[CORNERS + 1];
    for (int i = 0; i <= CORNERS; i++) {
      double bearing = pose.headingRad() + Math.PI * (0.5 + (double) i / CORNERS);
      norths[i] = pose.northM() + radiusM * Math.cos(bearing);
      easts[i] = pose.eastM() + radiusM * Math.sin(bearing);
    }
    unseen = List.of(PlanarShape.wall("unseen", norths, easts));
    tell();
  }

  /** Called when a route is blocked; takes effect with the next state. */
  void blocked(RouteTrack track, long micros) {
    gaps.blocked(track, world.costs(), micros);
    tell();
  }

  /** Closes the wrong sides of marks to be passed on one side. */
  void keepSides(
      Pose pose, StateInformation state, Optional<RouteTrack> track, AvoidanceVariables now) {
    Map<PassSides.Side, List<PlanarShape>> seen = new EnumMap<>(PassSides.Side.class);
    PassSides.parse(now.passSides())
        .forEach(
            (type, side) ->
                seen.computeIfAbsent(side, each -> new ArrayList<>())
                    .addAll(world.of(type, state)));
    if (sides.see(seen, pose, track, now.passReach(), now.body(true).circleM())) {
      tell();
    }
  }

  private void tell() {
    List<PlanarShape> all = new ArrayList<>(wayBack);
    all.addAll(unseen);
    all.addAll(gaps.shapes());
    all.addAll(sides.shapes());
    world.guess(all);
  }

  /**
   * Gaps that appear open only from a distance. Scanner errors widen obstacles where they are seen
   * best, so a gap may close as the vehicle approaches and open again as it leaves. Two such gaps
   * would make the vehicle oscillate, so a gap that closed twice counts as closed while another
   * route exists. Confined to the planner's thread.
   */
  static final class FalseGaps {
    /** Maximum distance at which a gap is seen reliably [radii of the vehicle with clearance]. */
    private static final double NEAR_RADII = 5.0;

    /** Minimum distance: any closer, and the vehicle would be inside the closed region. */
    private static final double MIN_RADII = 1.5;

    /** Closures sooner than this belong to the same attempt. */
    private static final long AGAIN_MICROS = 3 * Clock.MICROS_PER_SECOND;

    private record Closure(double northM, double eastM, long micros) {
      boolean isAt(double north, double east, double withinM) {
        return Math.hypot(north - northM, east - eastM) <= withinM;
      }
    }

    private final List<Closure> closures = new ArrayList<>();
    private List<PlanarShape> closed = List.of();

    List<PlanarShape> shapes() {
      return closed;
    }

    /** Resets, such as for another goal or if no other route exists. */
    void forget() {
      closures.clear();
      closed = List.of();
    }

    /** Called when the vehicle's route has just been blocked. */
    void blocked(RouteTrack route, CostGrid costs, long micros) {
      double radius = costs.inflation().radiusM();
      OptionalDouble ahead = firstClosedM(route, costs, NEAR_RADII * radius);
      if (ahead.isEmpty() || ahead.getAsDouble() < MIN_RADII * radius) {
        return;
      }
      double north = route.northAheadM(ahead.getAsDouble());
      double east = route.eastAheadM(ahead.getAsDouble());
      boolean again = false;
      for (Closure before : closures) {
        boolean same = before.isAt(north, east, radius);
        if (same && micros - before.micros() < AGAIN_MICROS) {
          return;
        }
        again |= same;
      }
      closures.add(new Closure(north, east, micros));
      if (again) {
        List<PlanarShape> more = new ArrayList<>(closed);
        more.add(PlanarShape.disc("gap", north, east, costs.frame().cellM()));
        closed = List.copyOf(more);
      }
    }

    /** Distance along the route to the first closed cell [m]; empty if none is near enough. */
    private static OptionalDouble firstClosedM(RouteTrack route, CostGrid costs, double withinM) {
      double step = 0.5 * costs.frame().cellM();
      double farthest = Math.min(withinM, route.remainingM());
      for (double ahead = 0.0; ahead <= farthest; ahead += step) {
        if (costs.cost(route.northAheadM(ahead), route.eastAheadM(ahead))
            == Double.POSITIVE_INFINITY) {
          return OptionalDouble.of(ahead);
        }
      }
      return OptionalDouble.empty();
    }
  }

  /**
   * Blocks the way back between two lines, such as those of a lane, behind a vehicle that has
   * reached a waypoint: the way ahead has not been seen yet and may be longer, but leads to the
   * next waypoint.
   */
  static final class WayBack {
    private static final double MARGIN_M = 1.0; // leaves room to turn and to back out

    private WayBack() {}

    /**
     * Chain from the nearest line on the left, behind the vehicle, to the nearest on the right;
     * empty unless both sides have a line.
     *
     * @param shapes static obstacles; chains among them are lines
     * @param circleM turning radius of the vehicle
     * @param reachM maximum distance of a line
     */
    static Optional<PlanarShape> closed(
        List<PlanarShape> shapes, Pose pose, double circleM, double reachM) {
      double[] left = nearest(shapes, pose, reachM, -1.0);
      double[] right = nearest(shapes, pose, reachM, 1.0);
      if (left.length == 0 || right.length == 0) {
        return Optional.empty();
      }
      Pose behind = pose.along(-circleM - MARGIN_M, 0.0);
      return Optional.of(
          PlanarShape.wall(
              "way back",
              new double[] {left[0], behind.northM(), right[0]},
              new double[] {left[1], behind.eastM(), right[1]}));
    }

    /** Nearest point of a chain on one side (1: right), north and east; an empty array if none. */
    private static double[] nearest(
        List<PlanarShape> shapes, Pose pose, double reachM, double side) {
      double[] found = {};
      double least = reachM;
      for (PlanarShape shape : shapes) {
        for (int i = 0; shape.kind() == PlanarShape.Kind.CHAIN && i < shape.count(); i++) {
          double north = shape.northM(i) - pose.northM();
          double east = shape.eastM(i) - pose.eastM();
          double right = east * Math.cos(pose.headingRad()) - north * Math.sin(pose.headingRad());
          double away = Math.sqrt(north * north + east * east);
          if (side * right > 0.0 && away < least) {
            least = away;
            found = new double[] {shape.northM(i), shape.eastM(i)};
          }
        }
      }
      return found;
    }
  }
}
