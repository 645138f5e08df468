package org.u2sa.planning.guidance;

import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.handover.HandOver;

/**
 * A loiter circle around a position. Radius 0 holds the position.
 *
 * <p>The direction follows from the vehicle's arrival: clockwise if the centre is on its right.
 */
public final class LoiterCircle {
  private static final double FARTHEST_AHEAD_RAD = 1.0;
  private static final int STEP_DEG = 5; // between places that are compared

  private final Place centre;
  private final double radiusM;
  private final double sense; // 1 clockwise, -1 counter-clockwise

  public LoiterCircle(Place centre, double radiusM, Vehicle vehicle) {
    this.centre = centre;
    this.radiusM = radiusM;
    Point to = vehicle.nedOf(centre);
    double course = vehicle.courseRad();
    sense = to.y() * Math.cos(course) - to.x() * Math.sin(course) >= 0.0 ? 1.0 : -1.0;
  }

  /**
   * Circle in a given direction.
   *
   * @param radiusM positive clockwise, negative counter-clockwise
   */
  public static LoiterCircle signed(Place centre, double radiusM) {
    return new LoiterCircle(centre, Math.abs(radiusM), Math.signum(radiusM));
  }

  private LoiterCircle(Place centre, double radiusM, double sense) {
    this.centre = centre;
    this.radiusM = radiusM;
    this.sense = sense;
  }

  /** Saves the circle under a name for the planner that takes over. */
  public void handOver(HandOver state, String name) {
    centre.handOver(state, name);
    state.number(name + " RADIUS", radiusM).number(name + " SENSE", sense);
  }

  /** Circle that the previous planner saved under a name; empty if none. */
  public static Optional<LoiterCircle> takenOver(HandOver state, String name) {
    return state.number(name + " RADIUS").isPresent()
        ? Place.takenOver(state, name)
            .map(
                centre ->
                    new LoiterCircle(
                        centre,
                        state.number(name + " RADIUS").getAsDouble(),
                        state.number(name + " SENSE").orElse(1.0)))
        : Optional.empty();
  }

  public Place centre() {
    return centre;
  }

  public double radiusM() {
    return radiusM;
  }

  /** 1 clockwise, -1 counter-clockwise. */
  public double sense() {
    return sense;
  }

  /** Distance from the circle's line [m], positive outside. */
  public double outsideM(Vehicle vehicle) {
    Point to = vehicle.nedOf(centre);
    return Math.hypot(to.x(), to.y()) - radiusM;
  }

  /** Distance of another position from the circle's line [m], positive outside. */
  public double outsideM(Place place, Vehicle vehicle) {
    Point from = vehicle.nedOf(centre).minus(vehicle.nedOf(place));
    return Math.hypot(from.x(), from.y()) - radiusM;
  }

  /**
   * Direction of the vehicle from the centre [rad, clockwise from north]; its course at the centre.
   */
  public double bearingRad(Vehicle vehicle) {
    Point to = vehicle.nedOf(centre);
    boolean atCentre = Math.hypot(to.x(), to.y()) < Leg.SHORTEST_M;
    return atCentre ? vehicle.courseRad() : Math.atan2(-to.y(), -to.x());
  }

  /**
   * Position on the circle.
   *
   * @param bearingRad its direction from the centre
   */
  public Place at(double bearingRad) {
    return centre.moved(radiusM * Math.cos(bearingRad), radiusM * Math.sin(bearingRad));
  }

  /** Part of the circle whose places are closed [degrees]. */
  public long closedDeg(Predicate<Place> isClosed) {
    return STEP_DEG
        * IntStream.range(0, 360 / STEP_DEG)
            .mapToObj(i -> at(Math.toRadians(i * STEP_DEG)))
            .filter(isClosed)
            .count();
  }

  /** Course along the circle at a direction from the centre [rad]. */
  public double courseRad(double bearingRad) {
    return bearingRad + sense * Math.PI / 2.0;
  }

  /**
   * Point on the circle, one look-ahead ahead; from outside on the straight way to the tangent
   * point, no farther than the look-ahead: a control that steers along an arc to a far point would
   * turn widely. North, east, down from the vehicle [m].
   *
   * @param widerM distance of the point outside the circle [m]
   */
  public Point tangentAhead(Vehicle vehicle, double lookAheadM, double widerM) {
    double away = outsideM(vehicle) + radiusM;
    double tangent = away > radiusM ? Math.acos(radiusM / away) : 0.0;
    double along = Math.min(lookAheadM / radiusM, FARTHEST_AHEAD_RAD);
    double bearing = bearingRad(vehicle) + sense * Math.max(tangent, along);
    double out = radiusM + widerM;
    Point to = vehicle.nedOf(centre.moved(out * Math.cos(bearing), out * Math.sin(bearing)));
    double share = tangent > along ? lookAheadM / Math.hypot(to.x(), to.y()) : 1.0;
    return share < 1.0 ? Point.of(share * to.x(), share * to.y(), to.z()) : to;
  }
}
