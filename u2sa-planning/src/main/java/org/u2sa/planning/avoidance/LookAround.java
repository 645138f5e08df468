package org.u2sa.planning.avoidance;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.curve.Pose;

/**
 * Directions in which a vehicle without a route looks for one: alternating sides. Confined to the
 * planner's thread.
 */
final class LookAround {
  private static final double STEP_RAD = Math.toRadians(60.0);
  private static final long EACH_MICROS = 5 * Clock.MICROS_PER_SECOND / 2;

  private long turnedMicros = Long.MIN_VALUE;
  private double headingRad;

  /** Heading to look to [rad]. */
  double headingRad(Pose pose, long micros) {
    if (turnedMicros == Long.MIN_VALUE || micros - turnedMicros > EACH_MICROS) {
      turnedMicros = micros;
      headingRad = Pose.wrapped(pose.headingRad() + STEP_RAD);
    }
    return headingRad;
  }
}
