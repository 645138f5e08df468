package org.u2sa.planning.avoidance;

import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.avoidance.Avoidance.Wanted;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.seen.GroundMap;
import org.u2sa.planning.seen.PlanningPlane;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Determines how far above the altitude of its goal an aircraft flies because of the ground, and
 * whether one that can stop rises straight up first. Altitudes are down coordinates on the planning
 * plane [m]. Confined to the planner's thread.
 */
final class CruiseAltitude {
  private static final double MIN_HEIGHT_M =
      3.0; // above the ground, from which it may move sideways
  private static final double MARGIN_M = 1.0; // above the clearance, over high ground
  private static final double RISES_M = 1.0; // smaller climbs are made on the way
  private static final double RISEN_M = 0.5; // below the altitude to which it rises
  private static final double STEP_M = 5.0; // between positions of a straight way, at least
  private static final double FARTHEST_M = 5000.0; // of it are looked at
  private static final int SAMPLES = 128; // of the planned area, in each direction
  private static final double NEAR_M = 10.0; // from its goal, it flies at the goal's altitude
  private static final double NOT_RAISED = Double.POSITIVE_INFINITY;

  private final GroundMap ground;
  private final SeenWorld world;
  private final VerticalEvasion limits;
  private final VerticalGuard guard;
  private boolean hasBegun;
  private boolean isFree; // the goal has no altitude of its own
  private boolean rises;
  private double riseDownM; // altitude to which it rises first
  private double leastDownM = NOT_RAISED; // lowest altitude on the way
  private double reachedDownM = NOT_RAISED; // highest altitude so far
  private boolean hasClimbed; // to it, at the last state

  /**
   * @param limits limits of altitudes
   * @param guard looks for obstacles above the vehicle
   */
  CruiseAltitude(GroundMap ground, SeenWorld world, VerticalEvasion limits, VerticalGuard guard) {
    this.ground = ground;
    this.world = world;
    this.limits = limits;
    this.guard = guard;
  }

  /** Forgets what was flown: the goal may be another one. */
  void begin() {
    hasBegun = false;
    rises = false;
    leastDownM = NOT_RAISED;
    reachedDownM = NOT_RAISED;
    hasClimbed = false;
  }

  /**
   * The goal at the altitude to be flown.
   *
   * @param wanted goal with an altitude
   * @param given goal as given, with or without one
   * @param at vehicle on the plane [m]
   */
  Wanted over(
      Wanted wanted,
      Wanted given,
      Vehicle vehicle,
      PlanningPlane plane,
      Point at,
      AvoidanceVariables now) {
    if (now.verticalClearance() == 0.0
        || vehicle.place().upM().isEmpty()
        || wanted.target().upM().isEmpty()
        || !ground.isOn(plane)) {
      begin();
      return wanted;
    }
    Point toGoal = vehicle.nedOf(wanted.target());
    see(vehicle, plane, at, toGoal, given.target().upM().isEmpty(), now);
    double raisedM = at.z() + toGoal.z() - downM(at, toGoal);
    double upM = wanted.target().upM().getAsDouble();
    return raisedM > 0.0 ? wanted.with(wanted.target().at(upM + raisedM)) : wanted;
  }

  private void see(
      Vehicle vehicle,
      PlanningPlane plane,
      Point at,
      Point toGoal,
      boolean free,
      AvoidanceVariables now) {
    double highestM = limits.highestDownM(plane, world, now);
    double reachM = RouteGround.reachM(now);
    double goalM = ground.highestM(at.x() + toGoal.x(), at.y() + toGoal.y(), reachM);
    if (!hasBegun || free != isFree) {
      begin();
      hasBegun = true;
      isFree = free;
      double hereM = ground.highestM(at.x(), at.y(), reachM);
      double goalAboveM = free ? Double.POSITIVE_INFINITY : goalM - at.z() - toGoal.z();
      if (now.stops()) {
        double keptM = Math.max(MIN_HEIGHT_M, ground.mappedM(at.x(), at.y()) - at.z());
        keptM = Math.min(keptM, Math.min(now.verticalClearance(), goalAboveM));
        double freeM = straightUpM(vehicle, at, Math.max(highestM, hereM - keptM), now);
        rises = freeM > RISES_M;
        riseDownM = at.z() - freeM;
      }
      if (free) {
        double clearM = hereM - now.verticalClearance();
        raise(at.z() - straightUpM(vehicle, at, Math.max(highestM, clearM), now));
      }
    }
    if (free) {
      raise(Math.max(highestM, goalM - now.verticalClearance()));
    }
    rises &= at.z() > riseDownM + RISEN_M;
    hasClimbed = at.z() < reachedDownM;
    reachedDownM = Math.min(reachedDownM, at.z());
  }

  private void raise(double downM) {
    if (downM < leastDownM) { // false if it is unknown
      leastDownM = downM;
    }
  }

  /** Part of a climb to an altitude that ends before what is above the vehicle [m]; at least 0. */
  private double straightUpM(Vehicle vehicle, Point at, double toDownM, AvoidanceVariables now) {
    double wayM = at.z() - toDownM;
    if (!(wayM > 0.0)) { // or the ground is unknown
      return 0.0;
    }
    Point up = Point.of(0.0, 0.0, -wayM);
    return world.costs() == null
        ? wayM
        : -guard.untilObstacle(vehicle, at, up, Optional.empty(), now.body(true), now);
  }

  /** Whether the vehicle has climbed to where it was not yet, since the last state. */
  boolean hasClimbed() {
    return hasClimbed;
  }

  /** Climb, down [m], before the vehicle moves sideways; 0 for none. */
  double riseM(Point at) {
    return rises ? riseDownM - at.z() : 0.0;
  }

  /** Altitude at which the vehicle flies on its way: that of the goal, or higher. */
  private double downM(Point at, Point toGoal) {
    return isThere(toGoal) ? at.z() + toGoal.z() : Math.min(at.z() + toGoal.z(), leastDownM);
  }

  private boolean isThere(Point toGoal) {
    return !isFree && Math.hypot(toGoal.x(), toGoal.y()) < NEAR_M;
  }

  /**
   * Raises the altitude because the ground leaves no way: above what is on the straight way or, if
   * that does not help, above all ground for which routes are planned. An aircraft that cannot stop
   * keeps to the altitude of a goal that has one.
   *
   * @param at vehicle on the plane [m]
   * @param toGoal vector to the goal, at the altitude flown so far [m]
   * @return whether it is higher than before
   */
  boolean raise(
      Vehicle vehicle, PlanningPlane plane, Point at, Point toGoal, AvoidanceVariables now) {
    if (!mayClimb(toGoal, now) || toGoal.z() < -RISES_M) {
      return false; // or it is still climbing
    }
    double before = at.z() + toGoal.z();
    for (double groundM : new double[] {straightWayM(at, toGoal, now), plannedM()}) {
      double highestM = limits.highestDownM(plane, world, now);
      double clearM = Math.max(highestM, aboveM(groundM, now));
      boolean isHigh = at.z() <= clearM; // it need only not descend yet
      double upM = straightUpM(vehicle, at, clearM, now);
      double toM = isHigh ? clearM : at.z() - upM;
      if ((isHigh || upM > 0.0) && toM < before - RISES_M) {
        raise(toM);
        return true;
      }
    }
    return false;
  }

  private boolean mayClimb(Point toGoal, AvoidanceVariables now) {
    return hasBegun && (isFree || now.stops() && !isThere(toGoal));
  }

  /**
   * Whether the vehicle can climb above the ground on the straight way, or does: nothing is above
   * it, up to there. Parameters as of {@link #raise}.
   */
  boolean clears(
      Vehicle vehicle, PlanningPlane plane, Point at, Point toGoal, AvoidanceVariables now) {
    double clearM = aboveM(straightWayM(at, toGoal, now), now);
    boolean climbs = toGoal.z() < -RISES_M || clearM < at.z() + toGoal.z() - RISES_M;
    return mayClimb(toGoal, now)
        && climbs
        && !(clearM < limits.highestDownM(plane, world, now))
        && straightUpM(vehicle, at, clearM, now) >= at.z() - clearM - RISEN_M;
  }

  /** Altitude at which it flies above ground, with room for errors of maps. */
  private static double aboveM(double groundM, AvoidanceVariables now) {
    return groundM - now.verticalClearance() - MARGIN_M;
  }

  /** Highest ground on the straight way to the goal, and beside it. */
  private double straightWayM(Point at, Point toGoal, AvoidanceVariables now) {
    double wayM = Math.hypot(toGoal.x(), toGoal.y());
    double lengthM = Math.min(FARTHEST_M, wayM);
    double reachM = RouteGround.reachM(now);
    double stepM = Math.max(STEP_M, reachM);
    double highestM = ground.highestM(at.x(), at.y(), reachM);
    for (double alongM = stepM; alongM < lengthM + stepM; alongM += stepM) {
      double share = Math.min(lengthM, alongM) / wayM;
      double north = at.x() + share * toGoal.x();
      highestM = higher(highestM, ground.highestM(north, at.y() + share * toGoal.y(), reachM));
    }
    return highestM;
  }

  /** Highest ground of the area for which routes are planned. */
  private double plannedM() {
    GridFrame frame = world.costs().frame();
    double highestM = Double.NaN;
    for (int row = 0; row <= SAMPLES; row++) {
      double north = frame.northM() + row * frame.rows() * frame.cellM() / SAMPLES;
      for (int column = 0; column <= SAMPLES; column++) {
        double east = frame.eastM() + column * frame.columns() * frame.cellM() / SAMPLES;
        highestM = higher(highestM, ground.mappedM(north, east));
      }
    }
    return highestM;
  }

  private static double higher(double oneM, double otherM) {
    return otherM < oneM || Double.isNaN(oneM) ? otherM : oneM;
  }
}
