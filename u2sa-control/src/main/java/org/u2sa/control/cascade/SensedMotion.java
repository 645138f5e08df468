package org.u2sa.control.cascade;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * The vehicle's motion without states, measured by an IMU and a velocity log: turn rate, and speeds
 * along the axes of a level vehicle.
 */
final class SensedMotion {
  private static final Attitude LEVEL = new Attitude(0.0, 0.0, 0.0);
  private static final double STALE_S = 1.0;

  private Attitude tilt = LEVEL;
  private double turnRadPerS;
  private Point velocity = Point.ORIGIN; // forward, left, down along the vehicle's axes [m/s]
  private double turnS = Double.NEGATIVE_INFINITY;
  private double velocityS = Double.NEGATIVE_INFINITY;

  /** Adds a sensor's measurement that has just arrived. */
  void sensed(StateInformation measured, long nowMicros) {
    ReferenceFrame frame = measured.referenceFrame();
    if (!frame.equals(ReferenceFrame.BODY) && measured.psiDot().isPresent()) {
      boolean isLeftward =
          frame.equals(ReferenceFrame.LOCAL_ENU) || frame.equals(ReferenceFrame.BODY_FLU);
      double sign = isLeftward ? -1.0 : 1.0; // in that frame, nose down is also positive
      turnRadPerS = sign * measured.psiDot().getAsDouble();
      tilt = new Attitude(measured.phi().orElse(0.0), sign * measured.theta().orElse(0.0), 0.0);
      turnS = Clock.seconds(nowMicros);
    }
    if (frame.isBody() && measured.xDot().isPresent()) {
      StateInformation body = measured.in(ReferenceFrame.BODY);
      velocity =
          Point.of(body.xDot().orElseThrow(), body.yDot().orElse(0.0), body.zDot().orElse(0.0));
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
