package org.u2sa.gcs.mavlink.telemetry;

import io.dronefleet.mavlink.common.NavControllerOutput;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;

/**
 * The message about the way to the goal. Its errors are wanted minus actual values, and 0 where
 * unknown: stations have no other value for that.
 */
final class NavigationMessages {
  private static final int FULL_TURN_DEG = 360;
  private static final int FARTHEST_M = 0xFFFF;
  private static final double NEAREST_M = 0.1; // of a point that has a direction

  private final VehicleStatus vehicle;
  private final FollowedRoute route;
  private final Placement placement;

  NavigationMessages(VehicleStatus vehicle, FollowedRoute route, Placement placement) {
    this.vehicle = vehicle;
    this.route = route;
    this.placement = placement;
  }

  Optional<Object> navigation() {
    Optional<StateInformation> here = placement.global();
    Optional<GoalInformation> goal =
        vehicle.goals().flatMap(list -> list.goals().stream().findFirst());
    if (here.isEmpty() || goal.isEmpty() || !(goal.get() instanceof Waypoint waypoint)) {
      return Optional.empty();
    }
    StateInformation state = here.get();
    Geodetic from =
        new Geodetic(state.x().getAsDouble(), state.y().getAsDouble(), state.z().orElse(0.0));
    Optional<Geodetic> next = route.next(state);
    return Placement.place(waypoint)
        .map(
            there -> {
              int targetDeg = bearingDeg(from, there);
              return NavControllerOutput.builder()
                  .navRoll((float) Math.toDegrees(state.phi().orElse(0.0)))
                  .navPitch((float) Math.toDegrees(state.theta().orElse(0.0)))
                  .navBearing(
                      next.filter(point -> from.distanceM(point) > NEAREST_M)
                          .map(point -> bearingDeg(from, point))
                          .orElse(targetDeg))
                  .targetBearing(targetDeg)
                  .wpDist((int) Math.min(FARTHEST_M, Math.round(from.distanceM(there))))
                  .altError((float) altitudeErrorM(waypoint, state, next))
                  .aspdError((float) speedErrorMps(state))
                  .xtrackError((float) route.crossTrackErrorM(from).orElse(0.0))
                  .build();
            });
  }

  private static int bearingDeg(Geodetic from, Geodetic to) {
    return (int) Math.round(Math.toDegrees(from.bearingRad(to))) % FULL_TURN_DEG;
  }

  /** Of the waypoint, or without an altitude of that, of the point to which the planner leads. */
  private double altitudeErrorM(
      Waypoint waypoint, StateInformation state, Optional<Geodetic> next) {
    if (state.z().isEmpty()) {
      return 0.0;
    }
    double altitudeM = state.z().getAsDouble();
    if (waypoint.z().isPresent()) {
      return waypoint.z().getAsDouble() - altitudeM;
    }
    return vehicle.kind().isOnSurface()
        ? 0.0
        : next.map(point -> point.altitudeM() - altitudeM).orElse(0.0);
  }

  /** 0 if control chooses the speed. */
  private double speedErrorMps(StateInformation state) {
    OptionalDouble wanted =
        route.navigation().map(NavigationPoint::speed).orElse(OptionalDouble.empty());
    OptionalDouble speed = MotionMessages.fluidSpeed(state, placement.velocity());
    return wanted.isPresent() && speed.isPresent()
        ? wanted.getAsDouble() - speed.getAsDouble()
        : 0.0;
  }
}
