package org.u2sa.planning.avoidance;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.Supplier;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.local.StopSpeed;
import org.u2sa.planning.local.SurfaceRoom;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.seen.PlanningPlane;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Answers whether and how fast a vehicle can move straight, for goals that are reached so. Confined
 * to the planner's thread.
 */
public final class StraightWays {
  private static final double STILL_MPS = 0.1; // slower motion has no direction

  private final Supplier<AvoidanceVariables> settings;
  private final Supplier<LineSettings> lines;
  private final SeenWorld world;
  private final RouteGround highGround;
  private final StraightFlight flight;
  private final Function<StateInformation, PlanningPlane> planes;
  private final Supplier<OptionalDouble> remainingM;

  /**
   * @param planes the planning plane of a state
   * @param remainingM remaining length of the route; empty without one
   */
  StraightWays(
      Supplier<AvoidanceVariables> settings,
      Supplier<LineSettings> lines,
      SeenWorld world,
      RouteGround highGround,
      Function<StateInformation, PlanningPlane> planes,
      Supplier<OptionalDouble> remainingM) {
    this.settings = settings;
    this.lines = lines;
    this.world = world;
    this.highGround = highGround;
    this.planes = planes;
    this.remainingM = remainingM;
    flight = new StraightFlight(world);
  }

  /**
   * Whether something is in the way of a vehicle that flies straight to a position: an obstacle
   * near the line, traffic, or the edge of the corridors.
   */
  public boolean isHindered(Vehicle vehicle, StateInformation state, Place to) {
    boolean hasTraffic = comesTraffic(vehicle, state, to);
    AvoidanceVariables now = settings.get();
    Point at = vehicle.on(planes.apply(state));
    return flight.isObstructed(vehicle, at, to, body(now), now)
        || hasTraffic
        || flight.leavesCorridors(at, vehicle.nedOf(to), now.planningCell());
  }

  /**
   * Whether ground is too high for a straight way to a position, with a climb or descent at once;
   * level to one without altitude.
   */
  public boolean isGroundBetween(Vehicle vehicle, StateInformation state, Place to) {
    AvoidanceVariables now = settings.get();
    PlanningPlane plane = planes.apply(state);
    return state.z().isPresent()
        && highGround.isBetween(
            plane, vehicle.on(plane), vehicle.nedOf(to), speedMps(vehicle, now), now);
  }

  /**
   * Likewise, of a straight way from anywhere that the vehicle leaves on the way: its end is no
   * goal.
   */
  public boolean isGroundAhead(Vehicle vehicle, StateInformation state, Place from, Place to) {
    AvoidanceVariables now = settings.get();
    PlanningPlane plane = planes.apply(state);
    Point ahead = vehicle.nedOf(from);
    return state.z().isPresent()
        && highGround.isAhead(
            plane,
            vehicle.on(plane).plus(ahead),
            vehicle.nedOf(to).minus(ahead),
            speedMps(vehicle, now),
            now);
  }

  /** Whether a straight way from one position to another leaves the corridors. */
  public boolean leavesCorridors(Vehicle vehicle, StateInformation state, Place from, Place to) {
    Point ahead = vehicle.nedOf(from);
    Point at = vehicle.on(planes.apply(state)).plus(ahead);
    return flight.leavesCorridors(
        at, vehicle.nedOf(to).minus(ahead), settings.get().planningCell());
  }

  private static double speedMps(Vehicle vehicle, AvoidanceVariables now) {
    return Math.max(vehicle.speedMps(), Math.max(now.minSpeed(), now.plannedSpeed()));
  }

  /** Whether ground is too high at a place of a circle about a centre of the same altitude. */
  public boolean isGroundAt(Vehicle vehicle, StateInformation state, Place place, Place centre) {
    PlanningPlane plane = planes.apply(state);
    Point at = vehicle.on(plane);
    return state.z().isPresent()
        && place.upM().isPresent()
        && highGround.isAt(
            plane, at.plus(vehicle.nedOf(place)), at.plus(vehicle.nedOf(centre)), settings.get());
  }

  /**
   * Whether a place is closed to a vehicle that cannot stop: it is lower above the ground than
   * VERTICAL CLEARANCE, an obstacle is near, or no corridor contains it.
   */
  public boolean isClosedAt(Vehicle vehicle, StateInformation state, Place place) {
    AvoidanceVariables now = settings.get();
    PlanningPlane plane = planes.apply(state);
    Point at = vehicle.on(plane);
    Point way = vehicle.nedOf(place);
    world.update(state, at.x(), at.y(), at.z(), at.z() + way.z());
    boolean isLow =
        state.z().isPresent()
            && place.upM().isPresent()
            && highGround.isLow(plane, at.plus(way), now);
    return isLow || flight.isClosed(at.plus(way), body(now), now);
  }

  /**
   * Whether a static obstacle, as of the last update, is too close to a straight descent to a point
   * on the ground. Near the ground, the required distance equals the aircraft's height.
   */
  public boolean blocksDescent(Vehicle vehicle, StateInformation state, Place from, Place to) {
    AvoidanceVariables now = settings.get();
    Point at = vehicle.on(planes.apply(state));
    return flight.blocksDescent(vehicle, at, from, to, body(now), now);
  }

  /**
   * Whether traffic comes close within the horizon if the vehicle flies straight on.
   *
   * @param to point to which it climbs or descends
   */
  public boolean comesTraffic(Vehicle vehicle, StateInformation state, Place to) {
    AvoidanceVariables now = settings.get();
    PlanningPlane plane = planes.apply(state);
    Point at = vehicle.on(plane);
    world.update(state, at.x(), at.y(), at.z(), at.z() + vehicle.nedOf(to).z());
    return flight.comesTraffic(vehicle, at, body(now), now);
  }

  /** Whether a straight way to a position leads into something that stands. */
  public boolean isBlocked(Vehicle vehicle, StateInformation state, Place to) {
    return blocker(vehicle, state, vehicle.nedOf(to)).isPresent();
  }

  /**
   * Room of a vehicle on a surface where it is.
   *
   * @param to position to which it would move straight
   */
  public SurfaceRoom room(Vehicle vehicle, StateInformation state, Place to) {
    AvoidanceVariables now = settings.get();
    PlanningPlane plane = planes.apply(state);
    Point at = vehicle.on(plane);
    Point way = vehicle.nedOf(to);
    world.update(state, at.x(), at.y(), at.z(), at.z() + way.z());
    CostGrid costs = world.costs();
    double touchM = now.touchM(costs.frame().cellM());
    double turnRadiusM = Situation.turnRadiusM(now, lines.get(), vehicle.speedMps());
    return new SurfaceRoom(costs, body(now), at, vehicle.headingRad(), way, touchM, turnRadiusM);
  }

  /**
   * Speed of a vehicle on a surface that moves straight to where it stops [m/s]: the wanted one, or
   * less to stop there, before what stands beyond, and before what stands where it is moving to.
   *
   * @param berths whether it moves along the straight way to a berth, which may be narrow
   */
  public double straightMps(
      Vehicle vehicle, StateInformation state, Avoidance.Wanted wanted, boolean berths) {
    SurfaceRoom room = room(vehicle, state, wanted.target());
    StopSpeed speed = stopSpeed(vehicle, wanted);
    double cellM = room.grid().frame().cellM();
    double reachM = cellM + speed.reachM(vehicle.speedMps());
    double freeM = berths ? room.freeInBerthM(reachM) : room.freeAlongWayM(reachM);
    double closing = room.alongWay(vehicle.northMps(), vehicle.eastMps());
    double thatWay = speed.mps(Math.min(room.wayM(), freeM - cellM), closing);
    if (berths || vehicle.speedMps() <= STILL_MPS) {
      return thatWay;
    }
    double aheadM = room.freeM(vehicle.courseRad(), reachM) - cellM;
    return Math.min(thatWay, speed.mps(aheadM, vehicle.speedMps()));
  }

  /** Speed from which the vehicle stops where its route ends, or at the goal without one [m/s]. */
  public double stoppableMps(Vehicle vehicle, Avoidance.Wanted wanted) {
    Point toGo = vehicle.nedOf(wanted.target());
    double wayM = Math.max(Math.hypot(toGo.x(), toGo.y()), remainingM.get().orElse(0.0));
    return stopSpeed(vehicle, wanted).mps(wayM, vehicle.speedMps());
  }

  private StopSpeed stopSpeed(Vehicle vehicle, Avoidance.Wanted wanted) {
    AvoidanceVariables now = settings.get();
    return new StopSpeed(Situation.limits(vehicle, wanted, now, lines.get(), now.planningCell()));
  }

  /** What stands on a straight way; empty if nothing does. */
  Optional<String> blocker(Vehicle vehicle, StateInformation state, Point way) {
    AvoidanceVariables now = settings.get();
    PlanningPlane plane = planes.apply(state);
    Point at = vehicle.on(plane);
    world.update(state, at.x(), at.y(), at.z(), at.z() + way.z());
    return flight.blocker(at, way, body(now), now);
  }

  private BodyDiscs body(AvoidanceVariables now) {
    return now.body(Situation.turnRadiusM(now, lines.get(), 0.0) == 0.0);
  }
}
