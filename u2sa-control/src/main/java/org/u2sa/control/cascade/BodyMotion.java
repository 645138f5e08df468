package org.u2sa.control.cascade;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * Motion of the vehicle along and about its forward, right and down axes.
 *
 * @param attitude attitude relative to north, east, down; roll and pitch are 0 if unknown
 * @param velocity velocity over ground: forward, right, down [m/s]; down is 0 if unknown
 * @param rates p, q, r [rad/s]; 0 if unknown
 */
record BodyMotion(Attitude attitude, Point velocity, Point rates) {
  /**
   * Creates the motion from a state in GLOBAL or LOCAL_NED.
   *
   * @param before heading of the previous state [rad], for deriving a missing yaw rate
   * @param stepS time since the previous state [s]; 0 if unknown
   * @return empty without heading or horizontal velocity, or in a vehicle frame
   */
  static Optional<BodyMotion> of(StateInformation state, OptionalDouble before, double stepS) {
    if (state.referenceFrame().isBody()) {
      return Optional.empty();
    }
    if (state.psi().isEmpty() || state.xDot().isEmpty() || state.yDot().isEmpty()) {
      return Optional.empty();
    }
    double heading = state.psi().getAsDouble();
    Attitude attitude = new Attitude(state.phi().orElse(0.0), state.theta().orElse(0.0), heading);
    double yawRate = 0.0;
    if (state.psiDot().isPresent()) {
      yawRate = state.psiDot().getAsDouble();
    } else if (before.isPresent() && stepS > 0.0) {
      yawRate = Math.IEEEremainder(heading - before.getAsDouble(), 2.0 * Math.PI) / stepS;
    }
    Point euler = Point.of(state.phiDot().orElse(0.0), state.thetaDot().orElse(0.0), yawRate);
    return Optional.of(
        new BodyMotion(attitude, frd(attitude, velocity(state)), attitude.bodyRates(euler)));
  }

  /** Copy that moves vertically only. */
  BodyMotion withoutHorizontalVelocity() {
    double down = attitude.nedFromFrd().times(velocity).z();
    return new BodyMotion(attitude, frd(Point.of(0.0, 0.0, down)), rates);
  }

  /**
   * Speed through air or water [m/s], on which the effect of control surfaces depends; ground speed
   * if it is not measured.
   */
  double speedThroughFluidMps(StateInformation state) {
    return state.fluidxDot().isPresent()
        ? Point.of(
                state.fluidxDot().getAsDouble(),
                state.fluidyDot().orElse(0.0),
                state.fluidzDot().orElse(0.0))
            .distance()
        : velocity.distance();
  }

  /** Velocity north, east, down [m/s]; in GLOBAL, states have east, north, up. */
  private static Point velocity(StateInformation state) {
    double x = state.xDot().orElseThrow();
    double y = state.yDot().orElseThrow();
    double z = state.zDot().orElse(0.0);
    return state.referenceFrame().isLocal() ? Point.of(x, y, z) : Point.of(y, x, -z);
  }

  private static Point frd(Attitude attitude, Point ned) {
    return attitude.nedFromFrd().transposed().times(ned);
  }

  /** Rotates a vector from north, east, down to forward, right, down. */
  Point frd(Point ned) {
    return frd(attitude, ned);
  }

  /** Rotates a vector from north, east, down to forward, right, down of the levelled vehicle. */
  Point level(Point ned) {
    Point fld = attitude.levelOf(ned);
    return Point.of(fld.x(), -fld.y(), fld.z());
  }

  /**
   * Rotates a vector from forward, right, down of the levelled vehicle to the vehicle's own axes.
   */
  Point fromLevel(Point level) {
    return frd(new Attitude(0.0, 0.0, attitude.psi()).nedFromFrd().times(level));
  }

  /** Velocity over ground: forward, right, down of the levelled vehicle [m/s]. */
  Point levelVelocity() {
    return level(attitude.nedFromFrd().times(velocity));
  }

  /**
   * Displacement between the positions of two states: north, east, down [m]; empty if one is
   * absent, or if they are in different frames. If one of them lacks a height, the height counts as
   * unchanged.
   */
  static Optional<Point> displacement(StateInformation then, StateInformation now) {
    boolean isAlike = then.referenceFrame().equals(now.referenceFrame());
    if (!isAlike || !hasPlace(then) || !hasPlace(now)) {
      return Optional.empty();
    }
    boolean hasHeight = then.z().isPresent() && now.z().isPresent();
    Point from = place(then, hasHeight);
    Point to = place(now, hasHeight);
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
