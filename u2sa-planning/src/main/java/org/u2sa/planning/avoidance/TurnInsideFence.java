package org.u2sa.planning.avoidance;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import java.util.function.BiPredicate;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.local.AllowedAreas;
import org.u2sa.planning.local.Area;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Turns a returning vehicle that can stop, but not turn in place, inside the fence in force: to the
 * side with room if its way home would turn it over the limit, otherwise it backs out until there
 * is room, or stops. Confined to the planner's thread.
 */
final class TurnInsideFence {
  private static final double BEGINS_RAD = Math.toRadians(30.0); // bearing of home
  private static final double ENDS_RAD = Math.toRadians(15.0);
  private static final double STEP_RAD = Math.toRadians(10.0); // of an arc, between checks
  private static final double LEAD_RAD = Math.toRadians(40.0); // of the arc, to the point ahead
  private static final double SHARE = 0.5; // of FENCE MARGIN, which braking may use up
  private static final double LESS_M = 0.05; // by which a vehicle outside may get farther out
  private static final double BACK_RADII = 0.5; // straight way back that must be inside
  private static final double MORE_RADII = 0.1; // additional room before it drives ahead again
  private static final double ROUTE_RADII = 5.0; // checked part of a route

  private final SeenWorld world;
  private final BiConsumer<String, Boolean> say;
  private final AllowedAreas areas;
  private double marginM; // FENCE MARGIN
  private boolean hasLimits;
  private Way way = Way.ORDINARY;

  private enum Way {
    ORDINARY(""),
    LEFT("turning left, inside the fence"),
    RIGHT("turning right, inside the fence"),
    BACK("no room to turn inside the fence: backing out"),
    STOP("no room to turn inside the fence: stopping");

    private final String words;

    Way(String words) {
      this.words = words;
    }

    private double side() {
      return this == RIGHT ? 1.0 : -1.0;
    }
  }

  /**
   * The vehicle and what it returns to.
   *
   * @param radiusM turn radius [m]
   * @param delayM way straight on until it turns [m]; negative in reverse
   * @param backwardsMps maximum speed in reverse [m/s]; 0 if it cannot reverse
   * @param isFree whether no obstacle is at a position, as far as the planner avoids any
   */
  private record Motion(
      Pose pose,
      double goalNorthM,
      double goalEastM,
      double radiusM,
      double delayM,
      double backwardsMps,
      BiPredicate<Double, Double> isFree) {
    private double bearingRad(Pose from) {
      double bearing = Math.atan2(goalEastM - from.eastM(), goalNorthM - from.northM());
      return Pose.wrapped(bearing - from.headingRad());
    }
  }

  TurnInsideFence(SeenWorld world, BiConsumer<String, Boolean> say) {
    this.world = world;
    this.say = say;
    areas = new AllowedAreas(world);
  }

  /** Receives the fence in force. */
  void see(FenceState inForce) {
    areas.see(inForce);
    marginM = inForce.margin();
    hasLimits = !inForce.keepIn().isEmpty() || !inForce.keepOut().isEmpty();
  }

  /** Called while the vehicle does not return. */
  void leave() {
    way = Way.ORDINARY;
  }

  /**
   * Changes the point to which a returning vehicle moves if the way there would leave the fence.
   *
   * @param at position on the plane [m]
   * @param toGoal vector to the goal: north, east, down [m]
   * @param radiusM turn radius [m]
   * @param route its route; empty without one, and without a route planner
   * @param avoids whether the planner avoids obstacles
   */
  void lead(
      NavigationPoint point,
      Vehicle vehicle,
      StateInformation state,
      Point at,
      Point toGoal,
      double radiusM,
      Optional<RouteTrack> route,
      boolean avoids,
      AvoidanceVariables now) {
    if (!hasLimits) {
      return;
    }
    Pose pose = new Pose(at.x(), at.y(), vehicle.headingRad());
    double along =
        vehicle.northMps() * Math.cos(pose.headingRad())
            + vehicle.eastMps() * Math.sin(pose.headingRad());
    double touchM = now.body(false).circleM() + now.touchM(now.planningCell());
    Motion motion =
        new Motion(
            pose,
            at.x() + toGoal.x(),
            at.y() + toGoal.y(),
            radiusM,
            (way == Way.BACK ? Math.max(along, now.plannedSpeed()) : along) * now.reactionTime(),
            now.backwardsMps(),
            (north, east) ->
                !avoids
                    || world.costs() == null // nothing has been seen yet
                    || world.costs().distanceM(north, east) >= touchM);
    Area area = areas.area(at, state);
    Way next = next(motion, area, avoids, route);
    if (next != way && next != Way.ORDINARY) {
      say.accept(next.words, next == Way.STOP);
    }
    way = next;
    apply(point, vehicle, motion);
  }

  private Way next(Motion motion, Area area, boolean avoids, Optional<RouteTrack> route) {
    double roomM = area.roomM(motion.pose().northM(), motion.pose().eastM());
    double bearing = motion.bearingRad(motion.pose());
    if (Double.isInfinite(roomM)
        || Math.abs(bearing) < (way == Way.ORDINARY ? BEGINS_RAD : ENDS_RAD)) {
      return Way.ORDINARY;
    }
    double keptM = roomM < 0.0 ? roomM - LESS_M : SHARE * Math.min(marginM, roomM);
    Way near = bearing > 0.0 ? Way.RIGHT : Way.LEFT;
    Way far = bearing > 0.0 ? Way.LEFT : Way.RIGHT;
    boolean turns = way == Way.LEFT || way == Way.RIGHT;
    if (turns && isInside(motion, area, way, keptM)) {
      return way;
    }
    double aheadM = way == Way.BACK ? keptM + MORE_RADII * motion.radiusM() : keptM;
    if (avoids && route.isPresent()) {
      if (isInside(route.get(), motion, area, aheadM)) {
        return Way.ORDINARY;
      }
    } else if (isInside(motion, area, near, aheadM)) {
      return way == Way.ORDINARY ? way : near; // the way there may turn less tightly
    }
    if (isInside(motion, area, far, aheadM)) {
      return far;
    }
    return backs(motion, area, keptM) ? Way.BACK : Way.STOP;
  }

  /** Whether the next part of a route keeps away from the limits. */
  private static boolean isInside(RouteTrack route, Motion motion, Area area, double keptM) {
    double farM = Math.min(route.remainingM(), ROUTE_RADII * motion.radiusM());
    double stepM = STEP_RAD * motion.radiusM();
    for (double aheadM = 0.0; aheadM <= farM; aheadM += stepM) {
      if (area.roomM(route.northAheadM(aheadM), route.eastAheadM(aheadM)) < keptM) {
        return false;
      }
    }
    return true;
  }

  /** Whether a turn towards the goal keeps away from the limits, and from obstacles. */
  private static boolean isInside(Motion motion, Area area, Way side, double keptM) {
    double curvature = side.side() / motion.radiusM();
    Pose start = motion.pose().along(motion.delayM(), 0.0);
    double stepM = STEP_RAD * motion.radiusM();
    for (int i = 0; i * STEP_RAD < 2.0 * Math.PI; i++) {
      Pose there = start.along(i * stepM, curvature);
      boolean isClear =
          area.roomM(there.northM(), there.eastM()) >= keptM
              && motion.isFree().test(there.northM(), there.eastM());
      if (!isClear) {
        return false;
      }
      if (Math.abs(motion.bearingRad(there)) < ENDS_RAD) {
        return true;
      }
    }
    return true;
  }

  private static boolean backs(Motion motion, Area area, double keptM) {
    if (motion.backwardsMps() == 0.0) {
      return false;
    }
    Pose behind = motion.pose().along(-BACK_RADII * motion.radiusM(), 0.0);
    return area.roomM(behind.northM(), behind.eastM()) >= keptM
        && motion.isFree().test(behind.northM(), behind.eastM());
  }

  private void apply(NavigationPoint point, Vehicle vehicle, Motion motion) {
    if (way == Way.ORDINARY) {
      return;
    }
    if (way == Way.STOP) {
      lead(point, vehicle, motion.pose(), motion.pose().along(motion.radiusM(), 0.0));
      point.speed(0.0);
    } else if (way == Way.BACK) {
      lead(point, vehicle, motion.pose(), motion.pose().along(-motion.radiusM(), 0.0));
      OptionalDouble wanted = point.speed();
      double mps = Math.min(wanted.orElse(Double.MAX_VALUE), motion.backwardsMps());
      point.backwards(true);
      if (Double.isFinite(mps) && mps < Double.MAX_VALUE) {
        point.speed(mps);
      }
    } else {
      double curvature = way.side() / motion.radiusM();
      lead(
          point,
          vehicle,
          motion.pose(),
          motion.pose().along(LEAD_RAD * motion.radiusM(), curvature));
      point.backwards(false);
    }
  }

  private static void lead(NavigationPoint point, Vehicle vehicle, Pose from, Pose to) {
    point.point(
        vehicle.body(Point.of(to.northM() - from.northM(), to.eastM() - from.eastM(), 0.0)));
  }
}
