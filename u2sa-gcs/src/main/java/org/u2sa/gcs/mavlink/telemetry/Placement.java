package org.u2sa.gcs.mavlink.telemetry;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;

/** Where the vehicle and its home are, in the frames that MAVLink knows. */
public final class Placement {
  private final VehicleStatus vehicle;

  public Placement(VehicleStatus vehicle) {
    this.vehicle = vehicle;
  }

  /** State in GLOBAL with a position; empty if unknown, or only known in a local frame. */
  public Optional<StateInformation> global() {
    return vehicle.state().flatMap(Placement::global);
  }

  private static Optional<StateInformation> global(StateInformation state) {
    return state.referenceFrame().isEarth() && state.x().isPresent() && state.y().isPresent()
        ? Optional.of(state.in(ReferenceFrame.GLOBAL))
        : Optional.empty();
  }

  /**
   * Home, or else the first position on the ground; empty if neither is on the earth, or if the
   * altitude of the home is not known: it is the mission's, or else that of the first position.
   */
  public Optional<Geodetic> home() {
    Optional<Geodetic> first = vehicle.first().flatMap((StateInformation state) -> place(state));
    Optional<Geodetic> home = vehicle.home().flatMap(Placement::place);
    OptionalDouble altitudeM = vehicle.homeAltitudeM();
    if (altitudeM.isEmpty() && first.isPresent()) {
      altitudeM = OptionalDouble.of(first.get().altitudeM());
    }
    double groundM = altitudeM.orElse(Double.NaN);
    return home.isPresent()
        ? home.filter(place -> !Double.isNaN(groundM))
            .map(place -> new Geodetic(place.longitudeDeg(), place.latitudeDeg(), groundM))
        : first;
  }

  /** Place of a state; empty if it is not on the earth, or has no horizontal position. */
  static Optional<Geodetic> place(StateInformation state) {
    return global(state)
        .map(
            global ->
                new Geodetic(
                    global.x().getAsDouble(), global.y().getAsDouble(), global.z().orElse(0.0)));
  }

  /** Place of a waypoint; empty if it is not on the earth, or has no horizontal position. */
  public static Optional<Geodetic> place(Waypoint waypoint) {
    if (!waypoint.referenceFrame().isEarth() || waypoint.x().isEmpty() || waypoint.y().isEmpty()) {
      return Optional.empty();
    }
    StateInformation place =
        new StateInformation()
            .referenceFrame(waypoint.referenceFrame())
            .x(waypoint.x().getAsDouble())
            .y(waypoint.y().getAsDouble())
            .in(ReferenceFrame.GLOBAL);
    return Optional.of(
        new Geodetic(place.x().getAsDouble(), place.y().getAsDouble(), waypoint.z().orElse(0.0)));
  }

  /** State in LOCAL_NED, relative to home if it is on the earth; empty without a position. */
  public Optional<StateInformation> local() {
    Optional<StateInformation> state =
        vehicle.state().filter(now -> now.x().isPresent() && now.y().isPresent());
    if (state.isEmpty() || state.get().referenceFrame().isBody()) {
      return Optional.empty();
    }
    if (state.get().referenceFrame().isLocal()) {
      return Optional.of(state.get().in(ReferenceFrame.LOCAL_NED));
    }
    return home().map(origin -> state.get().in(ReferenceFrame.LOCAL_NED, origin));
  }

  /**
   * Velocity along north, east, down [m/s]; unknown components are 0; empty if neither horizontal
   * one is known.
   */
  public Optional<Point> velocity() {
    return vehicle.state().flatMap(Placement::velocity);
  }

  private static Optional<Point> velocity(StateInformation state) {
    if (state.referenceFrame().isBody() || state.xDot().isEmpty() || state.yDot().isEmpty()) {
      return Optional.empty();
    }
    StateInformation levelled =
        state.referenceFrame().isLocal()
            ? state.in(ReferenceFrame.LOCAL_ENU)
            : state.in(ReferenceFrame.GLOBAL);
    return Optional.of(
        Point.of(
            levelled.yDot().orElse(0.0),
            levelled.xDot().orElse(0.0),
            -levelled.zDot().orElse(0.0)));
  }

  /** State whose attitude is roll right, pitch up and heading from north; empty without heading. */
  public Optional<StateInformation> attitude() {
    return vehicle
        .state()
        .filter(state -> !state.referenceFrame().isBody())
        .map(
            state ->
                state.referenceFrame().isLocal()
                    ? state.in(ReferenceFrame.LOCAL_NED)
                    : state.in(ReferenceFrame.GLOBAL))
        .filter(state -> state.psi().isPresent());
  }
}
