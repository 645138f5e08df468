package org.u2sa.planning.guidance;

import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.handover.HandOver;

/**
 * A loiter circle around a position. Radius 0 holds the position.
 *
 * <p>The direction follows from the vehicle's arrival: clockwise if the centre is on its right.
 */
public final class LoiterCircle {
  private static final double FARTHEST_AHEAD_RAD = 1.0;

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

  private LoiterCircle(Place centre, double radiusM, double sense) {
    this.centre = centre;
    this.radiusM = radiusM;
    this.sense = sense;
  }

  /** Saves the circle for the planner that takes over. */
  public void handOver(HandOver state) {
    centre.handOver(state, "CIRCLE");
    state.number("CIRCLE RADIUS", radiusM).number("CIRCLE SENSE", sense);
  }

  /** Circle of the previous planner; empty if none. */
  public static Optional<LoiterCircle> takenOver(HandOver state) {
    return state.number("CIRCLE RADIUS").isPresent()
        ? Place.takenOver(state, "CIRCLE")
            .map(
                centre ->
                    new LoiterCircle(
                        centre,
                        state.number("CIRCLE RADIUS").getAsDouble(),
                        state.number("CIRCLE SENSE").orElse(1.0)))
        : Optional.empty();
  }

  /** Point on the circle, one look-ahead ahead: north, east, down from the vehicle [m]. */
  public Point ahead(Vehicle vehicle, double lookAheadM) {
    Point to = vehicle.nedOf(centre);
    if (radiusM == 0.0) {
      return to;
    }
    boolean atCentre = Math.hypot(to.x(), to.y()) < Leg.SHORTEST_M;
    double angle = atCentre ? vehicle.courseRad() : Math.atan2(-to.y(), -to.x());
    angle += sense * Math.min(lookAheadM / radiusM, FARTHEST_AHEAD_RAD);
    return Point.of(to.x() + radiusM * Math.cos(angle), to.y() + radiusM * Math.sin(angle), to.z());
  }
}
