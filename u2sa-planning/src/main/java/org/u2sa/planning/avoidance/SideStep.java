package org.u2sa.planning.avoidance;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.local.AllowedAreas;
import org.u2sa.planning.local.Area;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.seen.Mover;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Moves a climb in place aside, over the known ground around it, if traffic descends onto the
 * vehicle and a descent does not help. The climb continues from there. Confined to the planner's
 * thread.
 */
final class SideStep {
  private static final double ASIDE_M = KnownGround.REACH_M - 2.0; // from the place on the ground
  private static final int DIRECTIONS = 16;
  private static final double SPENT_M = 1.0; // descents below this do not evade
  private static final double DESCENDS_MPS = 0.5; // less may be an error of its altitude
  private static final double WITHIN_S = 8.0; // enough to move aside; later is too uncertain
  private static final double CHECK_M = 0.5; // distance between positions that are checked
  private static final double FARTHER_M = 1.0; // by which another position must be better

  private final SeenWorld world;
  private final BiConsumer<String, Boolean> say;
  private final AllowedAreas fence;
  private String goal = "";
  private Optional<Place> aside = Optional.empty(); // where the climb to the goal continues

  SideStep(SeenWorld world, BiConsumer<String, Boolean> say) {
    this.world = world;
    this.say = say;
    fence = new AllowedAreas(world);
  }

  /** Receives the fence in force, whose areas it respects. */
  void see(FenceState inForce) {
    fence.see(inForce);
  }

  /**
   * Way in a climb: the given one, or with horizontal components that lead aside [m].
   *
   * @param pursued UID of the goal
   * @param way north and east as wanted, down as far as it avoids traffic [m]
   * @param spot known ground below the vehicle on the plane [m]
   */
  Point way(
      String pursued,
      Vehicle vehicle,
      StateInformation state,
      Point way,
      Optional<Point> spot,
      List<Mover> traffic,
      AvoidanceVariables now) {
    if (!pursued.equals(goal) || spot.isEmpty()) {
      goal = pursued;
      aside = Optional.empty();
    }
    Point at = vehicle.on(world.plane(state));
    boolean isSpent = way.z() >= 0.0 && way.z() < SPENT_M;
    boolean flies = spot.filter(low -> !KnownGround.isLow(low, at)).isPresent();
    if (isSpent && flies) {
      Point wanted = aside.map(vehicle::nedOf).orElse(way);
      Point kept = Point.of(at.x() + wanted.x(), at.y() + wanted.y(), at.z());
      double keptM = now.body(true).circleM() + now.trafficClearance();
      Optional<Point> lands = landing(traffic, kept, keptM, vehicle.timestampMicros(), now);
      lands
          .flatMap(on -> away(at, spot.get(), on, awayM(kept, on) + FARTHER_M, state, now))
          .ifPresent(
              to -> {
                aside = Optional.of(vehicle.place().moved(to.x() - at.x(), to.y() - at.y()));
                say.accept("traffic descends onto the vehicle: moving aside", false);
              });
    }
    Point to = aside.map(vehicle::nedOf).orElse(way);
    return Point.of(to.x(), to.y(), way.z());
  }

  /** Where traffic will be when it has descended to within the clearance above a position [m]. */
  private static Optional<Point> landing(
      List<Mover> traffic, Point kept, double keptM, long micros, AvoidanceVariables now) {
    for (Mover mover : VerticalGuard.above(traffic, kept, micros)) {
      double ageS = mover.ageS(micros);
      double mps = mover.heights().downMps();
      if (mps < DESCENDS_MPS) {
        continue;
      }
      double aboveM = kept.z() - mover.downAfterM(ageS);
      double inS = Math.max(0.0, (aboveM - now.verticalClearance()) / mps);
      Point then = Point.of(mover.northAfterM(ageS + inS), mover.eastAfterM(ageS + inS), kept.z());
      if (inS < Math.min(WITHIN_S, now.trafficHorizon()) && awayM(kept, then) < keptM) {
        return Optional.of(then);
      }
    }
    return Optional.empty();
  }

  /** The position on the known ground farthest from traffic to which the way is free. */
  private Optional<Point> away(
      Point at,
      Point spot,
      Point traffic,
      double leastM,
      StateInformation state,
      AvoidanceVariables now) {
    Optional<Point> best = Optional.empty();
    double mostM = leastM;
    for (int i = 0; i < DIRECTIONS; i++) {
      double bearing = 2.0 * Math.PI * i / DIRECTIONS;
      Point to =
          Point.of(
              spot.x() + ASIDE_M * Math.cos(bearing),
              spot.y() + ASIDE_M * Math.sin(bearing),
              at.z());
      if (awayM(to, traffic) > mostM && isFree(at, to, traffic, state, now)) {
        mostM = awayM(to, traffic);
        best = Optional.of(to);
      }
    }
    return best;
  }

  /** Whether a way leads past obstacles and inside the fence, and not closer to the traffic. */
  private boolean isFree(
      Point at, Point to, Point traffic, StateInformation state, AvoidanceVariables now) {
    BodyDiscs body = now.body(true);
    double touchM = now.touchM(world.costs().frame().cellM());
    Area allowed = fence.area(at, state);
    int steps = (int) Math.ceil(awayM(at, to) / CHECK_M);
    double leastM = awayM(at, traffic) - CHECK_M;
    for (int i = 1; i <= steps; i++) {
      double north = at.x() + (to.x() - at.x()) * i / steps;
      double east = at.y() + (to.y() - at.y()) * i / steps;
      boolean isBlocked = world.costs().distanceM(north, east) - body.circleM() < touchM;
      boolean nears = Math.hypot(north - traffic.x(), east - traffic.y()) < leastM;
      if (isBlocked || nears || !allowed.contains(north, east)) {
        return false;
      }
    }
    return true;
  }

  private static double awayM(Point one, Point other) {
    return Math.hypot(one.x() - other.x(), one.y() - other.y());
  }
}
