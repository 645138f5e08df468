package org.u2sa.planning.avoidance;

import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.seen.FlightProfile;
import org.u2sa.planning.seen.GroundMap;
import org.u2sa.planning.seen.PlanningPlane;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Determines the altitudes at which an aircraft will fly to its goal, and with them which ground is
 * too high for its route. Confined to the planner's thread.
 */
final class RouteGround {
  /** Smaller changes of an altitude do not matter [fraction of VERTICAL CLEARANCE]. */
  private static final double SAME = 0.4;

  private static final double ROUGHLY_M = 1.0; // error of maps
  private static final double FARTHEST_M = 5000.0; // a way is checked so far ahead
  private static final double ROUNDING_M = 0.01; // on the way to a goal as low as its clearance
  private static final double STEP_M = 5.0; // between checked positions, at least
  private static final double NEXT_M = 1.0; // likewise, of the way to stop
  private static final double NEAR_M = 10.0; // from its goal, it descends at once
  private static final double CELLS = 1.5; // rounding of places to cells
  private static final double HALF = 0.5; // of a height: ground beside it that rises more counts

  private final GroundMap ground;
  private final SeenWorld world;
  private final DoubleSupplier slope;
  private Optional<FlightProfile> profile = Optional.empty();
  private PlanningPlane on;
  private double goalNorthM; // on the plane
  private double goalEastM;
  private double aboveM; // distance to keep above ground

  /**
   * @param slope slope of climbs and descents of vehicles without EVASION CLIMB
   */
  RouteGround(GroundMap ground, SeenWorld world, DoubleSupplier slope) {
    this.ground = ground;
    this.world = world;
    this.slope = slope;
  }

  /** Forgets the altitudes to be flown: the goal may be another one. */
  void begin() {
    profile = Optional.empty();
  }

  /** No ground counts: the vehicle does not follow a route. */
  void leave() {
    begin();
    world.flyAbove(profile, ground::mappedM);
  }

  /** Whether ground counts as an obstacle. */
  boolean counts() {
    return profile.isPresent();
  }

  /**
   * Sets which ground counts as an obstacle.
   *
   * @param at vehicle on the plane [m]
   * @param toGoal vector to the goal [m]
   * @param hasAltitudes whether the altitudes of both are known
   * @param speedMps speed at which it climbs or descends [m/s]
   * @return reason for giving up the goal: it is in the ground; empty if it is not
   */
  Optional<String> see(
      PlanningPlane plane,
      Point at,
      Point toGoal,
      boolean hasAltitudes,
      double speedMps,
      AvoidanceVariables now) {
    if (!hasAltitudes || now.verticalClearance() == 0.0 || !ground.isOn(plane)) {
      leave();
      return Optional.empty();
    }
    double goalDownM = at.z() + toGoal.z();
    double keptM = keptM(at, toGoal, now);
    if (!isFlown(at, goalDownM, keptM, now.verticalClearance())) {
      profile = Optional.of(flown(at, toGoal, keptM, speedMps, now));
    }
    on = plane;
    goalNorthM = at.x() + toGoal.x();
    goalEastM = at.y() + toGoal.y();
    aboveM = keptM;
    world.flyAbove(profile, ground::mappedM);
    double goalM = ground.mappedM(at.x() + toGoal.x(), at.y() + toGoal.y()) - goalDownM;
    return goalM < -ROUGHLY_M
        ? Optional.of(
            String.format(
                Locale.ROOT, "the ground at the goal is %.0f m higher than the goal", -goalM))
        : Optional.empty();
  }

  /**
   * Lowest altitude to which a vehicle that can stop descends on its route: above the ground and,
   * among high ground, to the altitude for which the route is planned. Down coordinate at a
   * position on the plane [m]; ∞ if no ground counts.
   */
  double lowestM(double north, double east) {
    if (profile.isEmpty()) {
      return Double.POSITIVE_INFINITY;
    }
    boolean isNear = Math.hypot(north - goalNorthM, east - goalEastM) < NEAR_M;
    return isNear || world.highGround().isEmpty()
        ? aboveGroundM(north, east)
        : Math.min(aboveGroundM(north, east), profile.get().downM(north, east));
  }

  private double aboveGroundM(double north, double east) {
    double down = ground.downM(on, north, east) - aboveM;
    return Double.isNaN(down) ? Double.POSITIVE_INFINITY : down;
  }

  /**
   * Part of a climb or descent, down [m], that keeps such a vehicle above the ground where it is
   * and wherever it passes before it can stop.
   *
   * @param at vehicle on the plane [m]
   */
  double above(Point at, Vehicle vehicle, double wayM, AvoidanceVariables now) {
    double lowestM = lowestM(at.x(), at.y());
    double mps = Math.hypot(vehicle.northMps(), vehicle.eastMps());
    double stopsM = mps * now.reactionTime() + mps * mps / (2.0 * now.plannedBraking());
    for (double alongM = NEXT_M; profile.isPresent() && alongM <= stopsM; alongM += NEXT_M) {
      double share = alongM / mps;
      double north = at.x() + share * vehicle.northMps();
      double east = at.y() + share * vehicle.eastMps();
      lowestM = Math.min(lowestM, aboveGroundM(north, east));
    }
    return Math.min(wayM, lowestM - at.z());
  }

  /**
   * Whether ground is too high for a straight way; parameters as of {@link #see}, except that
   * altitudes are known.
   */
  boolean isBetween(
      PlanningPlane plane, Point at, Point way, double speedMps, AvoidanceVariables now) {
    return isBetween(plane, at, way, way, speedMps, now);
  }

  /** Likewise, of a straight way that the vehicle leaves somewhere: its end is no goal. */
  boolean isAhead(
      PlanningPlane plane, Point at, Point way, double speedMps, AvoidanceVariables now) {
    return isBetween(plane, at, way, Point.ORIGIN, speedMps, now);
  }

  private boolean isBetween(
      PlanningPlane plane,
      Point at,
      Point way,
      Point toGoal,
      double speedMps,
      AvoidanceVariables now) {
    if (now.verticalClearance() == 0.0 || !ground.isOn(plane)) {
      return false;
    }
    FlightProfile straight = flown(at, way, keptM(at, toGoal, now), speedMps, now);
    double lengthM = Math.min(FARTHEST_M, Math.hypot(way.x(), way.y()));
    double north = lengthM == 0.0 ? 0.0 : way.x() / Math.hypot(way.x(), way.y());
    double east = lengthM == 0.0 ? 0.0 : way.y() / Math.hypot(way.x(), way.y());
    double stepM = Math.max(STEP_M, now.planningCell());
    for (double along = 0.0; along <= lengthM; along += stepM) {
      double n = at.x() + along * north;
      double e = at.y() + along * east;
      double groundM = ground.mappedM(n, e) + ROUNDING_M;
      // lines may climb evenly
      double evenlyM = at.z() + along / Math.max(ROUNDING_M, lengthM) * Math.min(0.0, way.z());
      boolean isLow = now.stops() && evenlyM + straight.keptM() > groundM;
      if (isLow || straight.isTooHigh(n, e, groundM)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Whether ground is too high at a place of a circle; likewise.
   *
   * @param place north, east and down on the plane [m]
   * @param centre of the circle, at its altitude; where it is lower than the clearance, that counts
   */
  boolean isAt(PlanningPlane plane, Point place, Point centre, AvoidanceVariables now) {
    if (now.verticalClearance() == 0.0 || !ground.isOn(plane)) {
      return false;
    }
    double centreM = ground.mappedM(centre.x(), centre.y()) - centre.z();
    double keptM = Math.min(now.verticalClearance(), centreM);
    return isLower(place, Double.isNaN(keptM) ? now.verticalClearance() : keptM);
  }

  /** Whether a place is lower above the ground than the clearance. */
  boolean isLow(PlanningPlane plane, Point place, AvoidanceVariables now) {
    return ground.isOn(plane) && isLower(place, now.verticalClearance());
  }

  private boolean isLower(Point place, double heightM) {
    return ground.mappedM(place.x(), place.y()) - place.z() < heightM - ROUGHLY_M;
  }

  /**
   * Distance to keep above ground: a vehicle or goal that is lower sets it [m]. On a slope, it is
   * measured above the highest ground beside them from which routes keep away: otherwise that
   * ground would enclose them.
   */
  private double keptM(Point at, Point toGoal, AvoidanceVariables now) {
    double clearance = now.verticalClearance();
    double hereM = aboveM(at.x(), at.y(), beginsDownM(at, toGoal, now), now);
    double goalM = aboveM(at.x() + toGoal.x(), at.y() + toGoal.y(), at.z() + toGoal.z(), now);
    double keptM = Double.isNaN(hereM) ? clearance : hereM;
    // a vehicle that began higher does not come that low
    keptM = Math.max(keptM, profile.map(FlightProfile::keptM).orElse(keptM));
    return Math.min(clearance, Double.isNaN(goalM) ? keptM : Math.min(keptM, goalM));
  }

  /**
   * Height above the ground at a place and beside it, or half of that at the place if it is more.
   */
  private double aboveM(double north, double east, double downM, AvoidanceVariables now) {
    double aboveM = ground.mappedM(north, east) - downM;
    double besideM = ground.highestM(north, east, reachM(now)) - downM;
    return Math.max(besideM, Math.min(aboveM, HALF * aboveM));
  }

  /** Distance that routes keep beside ground that is too high, in whole cells [m]. */
  static double reachM(AvoidanceVariables now) {
    return now.body(now.stops()).circleM() + now.clearance() + CELLS * now.planningCell();
  }

  /** Altitude at which the expected flight begins. */
  private static double beginsDownM(Point at, Point toGoal, AvoidanceVariables now) {
    boolean isLevel = Math.abs(toGoal.z()) <= SAME * now.verticalClearance();
    return isLevel ? at.z() + toGoal.z() : at.z();
  }

  private FlightProfile flown(
      Point at, Point toGoal, double keptM, double speedMps, AvoidanceVariables now) {
    double climb = now.evasionClimb();
    return new FlightProfile(
        at.x(),
        at.y(),
        beginsDownM(at, toGoal, now),
        at.z() + toGoal.z(),
        climb == 0.0 ? slope.getAsDouble() : climb / Math.max(climb, speedMps),
        keptM);
  }

  /** Whether the vehicle flies as expected, so that routes remain comparable. */
  private boolean isFlown(Point at, double goalDownM, double keptM, double clearance) {
    double sameM = SAME * clearance;
    return profile.isPresent()
        && Math.abs(profile.get().downM(at.x(), at.y()) - at.z()) <= sameM
        && Math.abs(profile.get().goalDownM() - goalDownM) <= 0.5 * sameM
        && Math.abs(profile.get().keptM() - keptM) <= 0.25 * sameM;
  }
}
