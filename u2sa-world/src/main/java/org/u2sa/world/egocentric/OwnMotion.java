package org.u2sa.world.egocentric;

import java.util.OptionalDouble;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * The vehicle's own motion as its sensors measure it now: attitude and turn rate by an IMU, speed
 * by a velocity log. Values older than a second count as 0.
 */
final class OwnMotion {
  private static final long STALE_MICROS = 1_000_000L;

  private double phi;
  private double theta;
  private double turnRadPerS; // of psi
  private Point velocity = Point.ORIGIN; // forward, left, down [m/s]
  private long turnMicros = Long.MIN_VALUE / 2;
  private long velocityMicros = Long.MIN_VALUE / 2;

  void sensed(StateInformation measured, long micros) {
    if (measured.psiDot().isPresent() && !measured.referenceFrame().isBody()) {
      turnRadPerS = measured.psiDot().getAsDouble();
      phi = measured.phi().orElse(0.0);
      theta = measured.theta().orElse(0.0);
      turnMicros = micros;
    }
    OptionalDouble forward = measured.xDot();
    if (forward.isPresent() && measured.referenceFrame().equals(ReferenceFrame.BODY)) {
      velocity =
          Point.of(
              forward.getAsDouble(), measured.yDot().orElse(0.0), measured.zDot().orElse(0.0));
      velocityMicros = micros;
    }
  }

  boolean knowsSpeed(long micros) {
    return micros - velocityMicros <= STALE_MICROS;
  }

  /** A direction of BODY in the axes of a level vehicle with the same heading. */
  Point level(Point body) {
    Point ned = new Attitude(phi, theta, 0.0).nedOf(body);
    return Point.of(ned.x(), -ned.y(), ned.z());
  }

  /** Where a place at rest is after a while, in the level axes of the vehicle, which has moved. */
  Point after(Point place, double seconds, long micros) {
    Point moved = knowsSpeed(micros) ? level(velocity).times(seconds) : Point.ORIGIN;
    double turned = micros - turnMicros <= STALE_MICROS ? turnRadPerS * seconds : 0.0;
    Point way = place.minus(moved);
    double c = Math.cos(turned);
    double s = Math.sin(turned);
    return Point.of(c * way.x() - s * way.y(), s * way.x() + c * way.y(), way.z());
  }

}
