package org.u2sa.control.cascade;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;

/**
 * Target of a vehicle's motion.
 *
 * @param way vector to the target: north, east, down [m]; empty to stop and hold the heading
 * @param speedMps speed on the way [m/s]; empty for the configured one
 * @param headingRad heading to hold, clockwise from north [rad]; empty if control chooses it
 * @param isBackwards whether a vehicle that faces its direction of travel goes stern first
 */
record MotionTarget(
    Optional<Point> way,
    Optional<Double> speedMps,
    OptionalDouble headingRad,
    boolean isBackwards) {
  private static final MotionTarget NONE =
      new MotionTarget(Optional.empty(), Optional.empty(), OptionalDouble.empty(), false);

  /** Whether the vehicle stops: without a way, or at a speed of 0. */
  boolean isStop() {
    return way.isEmpty() || speedMps.isPresent() && speedMps.get() == 0.0;
  }

  /** Stops and holds the heading. */
  static MotionTarget none() {
    return NONE;
  }
}
