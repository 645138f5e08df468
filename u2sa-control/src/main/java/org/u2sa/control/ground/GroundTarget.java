package org.u2sa.control.ground;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * Target of a ground vehicle relative to its current pose, in the horizontal plane.
 *
 * @param forwardM distance ahead of the vehicle [m]; negative behind
 * @param leftM distance to the left [m]; negative to the right
 * @param speedMps speed toward the target [m/s]; empty if control chooses it
 * @param backwards whether to go there in reverse
 * @param turnRad turn wanted there [rad], left positive; empty if any heading will do
 * @param byHand wanted motion instead of a target; empty unless the vehicle is driven by hand
 */
record GroundTarget(
    double forwardM,
    double leftM,
    OptionalDouble speedMps,
    boolean backwards,
    OptionalDouble turnRad,
    Optional<Drive> byHand) {

  GroundTarget(double forwardM, double leftM, OptionalDouble speedMps, boolean backwards) {
    this(forwardM, leftM, speedMps, backwards, OptionalDouble.empty(), Optional.empty());
  }

  /** A motion instead of a position. */
  static GroundTarget byHand(Drive drive) {
    return new GroundTarget(
        Double.POSITIVE_INFINITY,
        0.0,
        OptionalDouble.empty(),
        false,
        OptionalDouble.empty(),
        Optional.of(drive));
  }

  /** Distance [m]. */
  double distanceM() {
    return Math.hypot(forwardM, leftM);
  }

  /** Bearing [rad, −π…π], left positive; 0 straight ahead. */
  double bearingRad() {
    return Math.atan2(leftM, forwardM);
  }

  /**
   * Transforms a point from one state's pose to a newer state's pose. Empty if either state lacks
   * position or heading, or if they are in different frames.
   *
   * @param ned point relative to the older state: north, east, down [m]
   * @param point point's speed, direction and turn
   */
  static Optional<GroundTarget> seenFrom(
      StateInformation then, Point ned, StateInformation now, NavigationPoint point) {
    boolean isAlike = then.referenceFrame().equals(now.referenceFrame());
    if (!isAlike || now.psi().isEmpty() || !hasPlace(then) || !hasPlace(now)) {
      return Optional.empty();
    }
    Point left = ned.minus(displacement(then, now)); // of the remaining way
    Point level = new Attitude(0.0, 0.0, now.psi().getAsDouble()).levelOf(left);
    return Optional.of(
        new GroundTarget(
            level.x(),
            level.y(),
            point.speed(),
            point.backwards(),
            leftRad(point.turn(), then, now),
            Optional.empty()));
  }

  /** Remainder of a right turn requested relative to an older state. */
  private static OptionalDouble leftRad(
      OptionalDouble turnRad, StateInformation then, StateInformation now) {
    if (turnRad.isEmpty() || then.psi().isEmpty()) {
      return OptionalDouble.empty();
    }
    double wantedRad = then.psi().getAsDouble() + turnRad.getAsDouble();
    return OptionalDouble.of(
        Math.IEEEremainder(now.psi().getAsDouble() - wantedRad, 2.0 * Math.PI));
  }

  static boolean hasPlace(StateInformation state) {
    return state.x().isPresent() && state.y().isPresent();
  }

  /** Displacement between two states in the same frame, GLOBAL or LOCAL_NED: north and east [m]. */
  static Point displacement(StateInformation then, StateInformation now) {
    return then.referenceFrame().isLocal()
        ? place(now).minus(place(then))
        : Geodetic.of(place(then)).nedOf(Geodetic.of(place(now)));
  }

  private static Point place(StateInformation state) {
    return Point.of(state.x().orElseThrow(), state.y().orElseThrow(), 0.0);
  }
}
