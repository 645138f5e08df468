package org.u2sa.core.control.ground;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.core.control.ControlSystem;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ArmingState;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.ServiceContext;

/**
 * What control systems of ground vehicles have in common: they go to the navigation point as it
 * lies now, and stand where there is none or the vehicle does not know where it is.
 */
abstract class GroundControl extends ControlSystem {
  private static final double FULL_PERCENT = 100.0;

  private boolean navigating;
  private boolean armed = true; // where nobody arms, motors obey at once
  private OptionalDouble headingRad = OptionalDouble.empty(); // of the state before

  GroundControl(ServiceContext context) {
    super(context, "Control");
    registerSubscriber(Channels.ARMING_STATE);
  }

  /**
   * How the vehicle moves.
   *
   * @param forwardMps speed ahead [m/s]; empty if unknown
   * @param yawRateRadPerS [rad/s], to the left positive; empty if unknown
   */
  record Measured(OptionalDouble forwardMps, OptionalDouble yawRateRadPerS) {
    /** Of a vehicle whose motors do not obey, feedback has nothing to learn. */
    static final Measured NOTHING = new Measured(OptionalDouble.empty(), OptionalDouble.empty());
  }

  /**
   * Commands the motors. Called once for each state.
   *
   * @param target where to go; empty: nowhere, the vehicle is to stop and stand
   * @param stepS since the call before [s]; 0 for the first one and after a gap
   */
  abstract void drive(Optional<GroundTarget> target, Measured measured, double stepS);

  @Override
  protected final void control(StateInformation state, Optional<NavigationPoint> point) {
    Optional<GroundTarget> target = point.flatMap(given -> target(given, state));
    if (target.isPresent() != navigating) {
      navigating = target.isPresent();
      log(LogLevelEnum.INFO, navigating ? "drives" : "no navigation: stands");
    }
    Measured measured = new Measured(forwardMps(state), yawRateRadPerS(state));
    headingRad = state.psi();
    drive(target, armed ? measured : Measured.NOTHING, stepS());
  }

  @Override
  protected final void received(U2SAData data) {
    if (data instanceof ArmingState state) {
      armed = state.armed();
    } else {
      unexpected(data);
    }
  }

  private Optional<GroundTarget> target(NavigationPoint point, StateInformation now) {
    return stateOf(point)
        .flatMap(
            then ->
                nedOf(point).flatMap(ned -> GroundTarget.seenFrom(then, ned, now, point.speed())));
  }

  private static OptionalDouble forwardMps(StateInformation state) {
    if (state.xDot().isEmpty() || state.yDot().isEmpty() || state.psi().isEmpty()) {
      return OptionalDouble.empty();
    }
    boolean northFirst = state.referenceFrame().equals(ReferenceFrame.LOCAL_NED);
    double x = state.xDot().getAsDouble();
    double y = state.yDot().getAsDouble();
    double heading = state.psi().getAsDouble();
    double north = northFirst ? x : y;
    double east = northFirst ? y : x;
    return OptionalDouble.of(north * Math.cos(heading) + east * Math.sin(heading));
  }

  /** As measured, or by how much the heading has changed since the state before. */
  private OptionalDouble yawRateRadPerS(StateInformation state) {
    if (state.psiDot().isPresent()) {
      return OptionalDouble.of(-state.psiDot().getAsDouble());
    }
    if (state.psi().isEmpty() || headingRad.isEmpty() || stepS() == 0.0) {
      return OptionalDouble.empty();
    }
    double turned =
        Math.IEEEremainder(state.psi().getAsDouble() - headingRad.getAsDouble(), 2.0 * Math.PI);
    return OptionalDouble.of(-turned / stepS());
  }

  /** Commands an actuator a share of all that it can [−1…1]. */
  final void commandShare(String actuator, double share) {
    command(actuator, FULL_PERCENT * share);
  }

  /** What an actuator was commanded last, by this or the control before [−1…1]; 0 if nothing. */
  final double lastShare(String actuator) {
    return lastCommand(actuator).orElse(0.0) / FULL_PERCENT;
  }
}
