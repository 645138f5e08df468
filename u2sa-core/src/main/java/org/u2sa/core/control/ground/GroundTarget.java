package org.u2sa.core.control.ground;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Where a ground vehicle is to go, as it lies from the vehicle now, on its level plane.
 *
 * @param forwardM ahead of the vehicle [m]; negative behind
 * @param leftM to the left of it [m]; negative to the right
 * @param speedMps at which to go there [m/s]; empty if control is to choose
 * @param backwards whether to go there with the rear first
 */
record GroundTarget(double forwardM, double leftM, OptionalDouble speedMps, boolean backwards) {

  /** How far away it is [m]. */
  double distanceM() {
    return Math.hypot(forwardM, leftM);
  }

  /** Its direction [rad, −π…π], to the left positive; 0 straight ahead. */
  double bearingRad() {
    return Math.atan2(leftM, forwardM);
  }

  /**
   * A point that was seen from one state, as it lies from a newer one: what the vehicle has gone
   * and turned meanwhile is taken off. Empty if either state lacks position or heading.
   *
   * @param ned where it was seen: north, east, down [m]
   * @param backwards whether to go there with the rear first
   */
  static Optional<GroundTarget> seenFrom(
      StateInformation then,
      Point ned,
      StateInformation now,
      OptionalDouble speedMps,
      boolean backwards) {
    if (now.psi().isEmpty() || !hasPlace(then) || !hasPlace(now)) {
      return Optional.empty();
    }
    Point left = ned.minus(displacement(then, now)); // of the way
    Point level = new Attitude(0.0, 0.0, now.psi().getAsDouble()).levelOf(left);
    return Optional.of(new GroundTarget(level.x(), level.y(), speedMps, backwards));
  }

  static boolean hasPlace(StateInformation state) {
    return state.x().isPresent() && state.y().isPresent();
  }

  /** North and east from one state to the other [m]. */
  static Point displacement(StateInformation then, StateInformation now) {
    if (then.referenceFrame().isLocal()) {
      Point from = place(then.in(ReferenceFrame.LOCAL_NED));
      return place(now.in(ReferenceFrame.LOCAL_NED)).minus(from);
    }
    return onEarth(then).nedOf(onEarth(now));
  }

  private static Geodetic onEarth(StateInformation state) {
    return Geodetic.of(place(state.in(ReferenceFrame.GLOBAL)));
  }

  private static Point place(StateInformation state) {
    return Point.of(state.x().orElseThrow(), state.y().orElseThrow(), 0.0);
  }
}
