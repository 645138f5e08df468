package org.u2sa.core.control.cascade;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * How the vehicle moves, along and about its forward, right and down axes.
 *
 * @param attitude against north, east, down; roll and pitch are 0 if they are not known
 * @param velocity over ground: forward, right, down [m/s]; down is 0 if it is not known
 * @param rates p, q, r [rad/s]; 0 if they are not known
 */
record BodyMotion(Attitude attitude, Point velocity, Point rates) {
  /**
   * Of a state.
   *
   * @param before heading of the state before [rad], for the yaw rate where the state has none
   * @param stepS since the state before [s]; 0: unknown
   * @return empty without heading or horizontal velocity, and in a frame of the vehicle itself
   */
  static Optional<BodyMotion> of(StateInformation state, OptionalDouble before, double stepS) {
    if (state.referenceFrame().isBody()) {
      return Optional.empty();
    }
    StateInformation ned = ned(state);
    if (ned.psi().isEmpty() || ned.xDot().isEmpty() || ned.yDot().isEmpty()) {
      return Optional.empty();
    }
    double heading = ned.psi().getAsDouble();
    Attitude attitude = new Attitude(ned.phi().orElse(0.0), ned.theta().orElse(0.0), heading);
    double yawRate = 0.0;
    if (ned.psiDot().isPresent()) {
      yawRate = ned.psiDot().getAsDouble();
    } else if (before.isPresent() && stepS > 0.0) {
      yawRate = Math.IEEEremainder(heading - before.getAsDouble(), 2.0 * Math.PI) / stepS;
    }
    Point euler = Point.of(ned.phiDot().orElse(0.0), ned.thetaDot().orElse(0.0), yawRate);
    return Optional.of(
        new BodyMotion(attitude, frd(attitude, velocity(ned)), attitude.bodyRates(euler)));
  }

  private static StateInformation ned(StateInformation state) {
    boolean local = state.referenceFrame().isLocal();
    return state.in(local ? ReferenceFrame.LOCAL_NED : ReferenceFrame.GLOBAL);
  }

  /** North, east, down [m/s]; GLOBAL says east, north, up. */
  private static Point velocity(StateInformation state) {
    double x = state.xDot().orElseThrow();
    double y = state.yDot().orElseThrow();
    double z = state.zDot().orElse(0.0);
    return state.referenceFrame().isLocal() ? Point.of(x, y, z) : Point.of(y, x, -z);
  }

  private static Point frd(Attitude attitude, Point ned) {
    return attitude.nedFromFrd().transposed().times(ned);
  }

  /** A vector of north, east, down along the vehicle's forward, right and down axes. */
  Point frd(Point ned) {
    return frd(attitude, ned);
  }

  /**
   * North, east, down from one state's place to another's [m]; empty if one has none. A height that
   * one of them lacks counts as unchanged.
   */
  static Optional<Point> displacement(StateInformation then, StateInformation now) {
    if (!hasPlace(then) || !hasPlace(now)) {
      return Optional.empty();
    }
    boolean hasHeight = then.z().isPresent() && now.z().isPresent();
    Point from = place(ned(then), hasHeight);
    Point to = place(ned(now), hasHeight);
    return Optional.of(
        then.referenceFrame().isLocal()
            ? to.minus(from)
            : Geodetic.of(from).nedOf(Geodetic.of(to)));
  }

  private static boolean hasPlace(StateInformation state) {
    return state.x().isPresent() && state.y().isPresent();
  }

  private static Point place(StateInformation state, boolean withHeight) {
    return Point.of(
        state.x().orElseThrow(),
        state.y().orElseThrow(),
        withHeight ? state.z().orElseThrow() : 0.0);
  }
}
