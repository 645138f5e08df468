package org.u2sa.control.ground;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.u2sa.control.ControlSystem;
import org.u2sa.control.allocation.ActuatorRoster;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ArmingState;

/**
 * Common part of ground control systems: the navigation point relative to the vehicle now, the
 * vehicle's measured motion, and whether its motors are present. In: arming-state, actuators.
 * Confined to the control's thread.
 */
final class GroundControl {
  private final ControlSystem control;
  private final Clock clock;
  private final Supplier<List<String>> motors;
  private final ActuatorRoster roster = new ActuatorRoster();
  private boolean navigating;
  private boolean powerless;
  private boolean armed = true; // without an arming service, motors obey at once
  private OptionalDouble headingRad = OptionalDouble.empty(); // of the previous state

  /**
   * @param motors names of the actuators that are all required to drive
   */
  GroundControl(ControlSystem control, Clock clock, Supplier<List<String>> motors) {
    this.control = control;
    this.clock = clock;
    this.motors = motors;
    control.subscribe(Channels.ARMING_STATE, this::heed);
    control.subscribe(Channels.ACTUATORS, announced -> roster.see(announced, clock.micros()));
  }

  private void heed(ArmingState state) {
    armed = state.armed();
  }

  /**
   * Measured motion of the vehicle.
   *
   * @param forwardMps forward speed [m/s]; empty if unknown
   * @param yawRateRadPerS yaw rate [rad/s], left positive; empty if unknown
   */
  record Measured(OptionalDouble forwardMps, OptionalDouble yawRateRadPerS) {
    /** Nothing measured: without a state, or while motors do not obey, feedback must not learn. */
    static final Measured NOTHING = new Measured(OptionalDouble.empty(), OptionalDouble.empty());
  }

  /**
   * Target; empty to stop. A motor announced as lost also stops the vehicle, which would otherwise
   * lurch on its return, or rest as if stalled.
   *
   * @param then state from which the point was computed
   * @param ned position of the point relative to the vehicle at that state: north, east, down [m]
   */
  Optional<GroundTarget> target(
      StateInformation now,
      Optional<NavigationPoint> point,
      Optional<StateInformation> then,
      Optional<Point> ned) {
    Optional<GroundTarget> target =
        then.isEmpty() || ned.isEmpty() || isPowerless()
            ? Optional.empty()
            : GroundTarget.seenFrom(
                then.get(),
                ned.get(),
                now,
                point.orElseThrow().speed(),
                point.orElseThrow().backwards());
    if (target.isPresent() != navigating) {
      navigating = target.isPresent();
      control.log(navigating ? "driving" : "no navigation: stopped");
    }
    return target;
  }

  private boolean isPowerless() {
    long now = clock.micros();
    List<String> lost =
        motors.get().stream()
            .filter(motor -> roster.left(motor, now) == 0.0)
            .collect(Collectors.toList());
    if (lost.isEmpty() == powerless) {
      powerless = !lost.isEmpty();
      control.log(powerless ? "lost " + String.join(", ", lost) : "all motors are available");
    }
    return powerless;
  }

  /**
   * Measured motion, as far as feedback may learn from it. Called once per state.
   *
   * @param stepS time since the previous call [s]; 0 for the first call and after a gap
   */
  Measured measured(StateInformation state, double stepS) {
    Measured measured = new Measured(forwardMps(state), yawRateRadPerS(state, stepS));
    headingRad = state.psi();
    return armed && !control.isStateless() ? measured : Measured.NOTHING;
  }

  private static OptionalDouble forwardMps(StateInformation state) {
    if (state.xDot().isEmpty() || state.yDot().isEmpty() || state.psi().isEmpty()) {
      return OptionalDouble.empty();
    }
    boolean northFirst = state.referenceFrame().isLocal();
    double x = state.xDot().getAsDouble();
    double y = state.yDot().getAsDouble();
    double heading = state.psi().getAsDouble();
    double north = northFirst ? x : y;
    double east = northFirst ? y : x;
    return OptionalDouble.of(north * Math.cos(heading) + east * Math.sin(heading));
  }

  /** Measured yaw rate, or the heading difference to the previous state divided by the step. */
  private OptionalDouble yawRateRadPerS(StateInformation state, double stepS) {
    if (state.psiDot().isPresent()) {
      return OptionalDouble.of(-state.psiDot().getAsDouble());
    }
    if (state.psi().isEmpty() || headingRad.isEmpty() || stepS == 0.0) {
      return OptionalDouble.empty();
    }
    double turned =
        Math.IEEEremainder(state.psi().getAsDouble() - headingRad.getAsDouble(), 2.0 * Math.PI);
    return OptionalDouble.of(-turned / stepS);
  }
}
