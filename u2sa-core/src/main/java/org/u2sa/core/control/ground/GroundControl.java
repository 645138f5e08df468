package org.u2sa.core.control.ground;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.core.control.ControlSystem;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ArmingState;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * What control systems of ground vehicles have in common: the navigation point as it lies from the
 * vehicle now, and how the vehicle moves. In: arming-state. Belongs to the control's thread.
 */
final class GroundControl {
  private final ControlSystem control;
  private boolean navigating;
  private boolean armed = true; // where nobody arms, motors obey at once
  private OptionalDouble headingRad = OptionalDouble.empty(); // of the state before

  GroundControl(ControlSystem control) {
    this.control = control;
    control.subscribe(Channels.ARMING_STATE, this::heed);
  }

  private void heed(ArmingState state) {
    armed = state.armed();
  }

  /**
   * How the vehicle moves.
   *
   * @param forwardMps speed ahead [m/s]; empty if unknown
   * @param yawRateRadPerS [rad/s], to the left positive; empty if unknown
   */
  record Measured(OptionalDouble forwardMps, OptionalDouble yawRateRadPerS) {
    /** Without a state, or of motors that do not obey, feedback has nothing to learn. */
    static final Measured NOTHING = new Measured(OptionalDouble.empty(), OptionalDouble.empty());
  }

  /**
   * Where to go; empty: nowhere, the vehicle is to stop and stand.
   *
   * @param then the state from which the point was computed
   * @param ned where the point lay then: north, east, down [m]
   */
  Optional<GroundTarget> target(
      StateInformation now,
      Optional<NavigationPoint> point,
      Optional<StateInformation> then,
      Optional<Point> ned) {
    Optional<GroundTarget> target =
        then.isEmpty() || ned.isEmpty()
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

  /**
   * How the vehicle moves, as far as feedback may learn from it. Called once for each state.
   *
   * @param stepS since the call before [s]; 0 for the first one and after a gap
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
    boolean northFirst = state.referenceFrame().equals(ReferenceFrame.LOCAL_NED);
    double x = state.xDot().getAsDouble();
    double y = state.yDot().getAsDouble();
    double heading = state.psi().getAsDouble();
    double north = northFirst ? x : y;
    double east = northFirst ? y : x;
    return OptionalDouble.of(north * Math.cos(heading) + east * Math.sin(heading));
  }

  /** As measured, or by how much the heading has changed since the state before. */
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
