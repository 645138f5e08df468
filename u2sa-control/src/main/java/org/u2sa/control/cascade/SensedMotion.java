package org.u2sa.control.cascade;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * The vehicle's motion without states, as an IMU and a velocity log measure it: turn rate, and
 * speeds along the axes of a level vehicle.
 */
final class SensedMotion {
  private static final Attitude LEVEL = new Attitude(0.0, 0.0, 0.0);
  private static final double STALE_S = 1.0;

  private Attitude tilt = LEVEL;
  private double turnRadPerS;
  private Point velocity = Point.ORIGIN; // forward, left, down along the vehicle's axes [m/s]
  private double turnS = Double.NEGATIVE_INFINITY;
  private double velocityS = Double.NEGATIVE_INFINITY;

  /** Adds what a sensor measured, which has arrived now [µs]. */
  void sensed(StateInformation measured, long nowMicros) {
    boolean isBody = measured.referenceFrame().equals(ReferenceFrame.BODY);
    if (!isBody && measured.psiDot().isPresent()) {
      turnRadPerS = measured.psiDot().getAsDouble();
      tilt = new Attitude(measured.phi().orElse(0.0), measured.theta().orElse(0.0), 0.0);
      turnS = Clock.seconds(nowMicros);
    }
    if (isBody && measured.xDot().isPresent()) {
      velocity =
          Point.of(
              measured.xDot().getAsDouble(),
              measured.yDot().orElse(0.0),
              measured.zDot().orElse(0.0));
      velocityS = Clock.seconds(nowMicros);
    }
  }

  /** Motion relative to the vehicle's current axes; empty unless both sensors have measured. */
  Optional<BodyMotion> now(long nowMicros) {
    double oldestS = Clock.seconds(nowMicros) - STALE_S;
    return turnS >= oldestS && velocityS >= oldestS
        ? Optional.of(new BodyMotion(LEVEL, tilt.nedOf(velocity), Point.of(0.0, 0.0, turnRadPerS)))
        : Optional.empty();
  }
}
