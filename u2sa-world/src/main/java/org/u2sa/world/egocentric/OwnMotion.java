package org.u2sa.world.egocentric;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.PoseHistory;

/**
 * The vehicle's motion over the last seconds: attitude and turn rate from an IMU, speed from a
 * velocity log, integrated in LOCAL_NED from an arbitrary position and heading.
 */
final class OwnMotion {
  private static final long STALE_MICROS = Clock.MICROS_PER_SECOND; // older ones count as 0

  private final PoseHistory poses = new PoseHistory();
  private Point place = Point.ORIGIN;
  private double psi;
  private Point velocity = Point.ORIGIN; // forward, left, down [m/s]
  private long velocityMicros = Long.MIN_VALUE / 2;

  /** Adds a sensor's measurement. */
  void sensed(StateInformation measured, long micros) {
    ReferenceFrame frame = measured.referenceFrame();
    if (frame.isBody() && measured.xDot().isPresent()) {
      StateInformation body = measured.in(ReferenceFrame.BODY);
      velocity =
          Point.of(body.xDot().orElseThrow(), body.yDot().orElse(0.0), body.zDot().orElse(0.0));
      velocityMicros = micros;
    }
    if (!frame.equals(ReferenceFrame.BODY) && measured.psiDot().isPresent()) {
      turned(measured, micros);
    }
  }

  private void turned(StateInformation imu, long micros) {
    long before = poses.newestMicros();
    long step = before == Long.MIN_VALUE ? 0L : micros - before;
    if (step < 0L) {
      return;
    }
    boolean isLeftward =
        imu.referenceFrame().equals(ReferenceFrame.LOCAL_ENU)
            || imu.referenceFrame().equals(ReferenceFrame.BODY_FLU);
    double sign = isLeftward ? -1.0 : 1.0; // there, nose down is also positive
    double seconds = Clock.seconds(Math.min(step, STALE_MICROS));
    double rate = sign * imu.psiDot().orElseThrow();
    psi += rate * seconds;
    Attitude attitude = new Attitude(imu.phi().orElse(0.0), sign * imu.theta().orElse(0.0), psi);
    Point ned = knowsSpeed(micros) ? attitude.nedOf(velocity) : Point.ORIGIN;
    place = place.plus(ned.times(seconds));
    StateInformation pose = level().phi(attitude.phi()).theta(attitude.theta());
    pose.xDot(ned.x()).yDot(ned.y()).zDot(ned.z()).psiDot(rate);
    pose.timestamp(micros);
    poses.add(pose);
  }

  private StateInformation level() {
    StateInformation pose = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED);
    return pose.x(place.x()).y(place.y()).z(place.z()).psi(psi).phi(0.0).theta(0.0);
  }

  /** Whether the velocity log is measuring. */
  boolean knowsSpeed(long micros) {
    return micros - velocityMicros <= STALE_MICROS;
  }

  /** Pose at a time; the newest if none is close to it. */
  StateInformation at(long micros) {
    return poses.at(micros, STALE_MICROS).orElseGet(this::level);
  }
}
