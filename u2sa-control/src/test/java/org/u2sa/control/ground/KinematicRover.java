package org.u2sa.control.ground;

import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * A ground vehicle whose motors lag and whose position and heading are measured with errors: a
 * constant one of heading, and noise. Enough to see whether a control drives.
 */
final class KinematicRover {
  static final Geodetic ORIGIN = new Geodetic(-81.0478, 29.1885, 0.0);
  private static final DriveCalibration MOTOR = new DriveCalibration(2.0, 0.08);
  private static final double POSITION_NOISE_M = 0.02;
  private static final double HEADING_NOISE_RAD = Math.toRadians(1.0);

  /** Speed and yaw rate of the vehicle for what its actuators are commanded [%]. */
  interface Kinematics {
    Drive drive(ToDoubleFunction<String> percent);
  }

  private final Kinematics kinematics;
  private final double headingErrorRad;
  double lagS = 0.2; // in which it takes up 63 % of a new motion
  private final SplittableRandom random = new SplittableRandom(7);
  double north;
  double east;
  double heading;
  double speed;
  double yawRate; // to the left

  KinematicRover(Kinematics kinematics, double headingErrorRad) {
    this.kinematics = kinematics;
    this.headingErrorRad = headingErrorRad;
  }

  /**
   * Two motors, 2 m/s at 100 % and nothing below 8 %, 0.44 m apart.
   *
   * @param mismatch by which the right one is faster and the left one slower
   */
  static Kinematics differential(double mismatch) {
    return percent ->
        new WheelSpeeds(
                (1.0 - mismatch) * MOTOR.speedMps(0.01 * percent.applyAsDouble("LEFT MOTOR")),
                (1.0 + mismatch) * MOTOR.speedMps(0.01 * percent.applyAsDouble("RIGHT MOTOR")))
            .drive(0.44);
  }

  /** 3 m/s at 100 %, 28 degrees of steering, 0.6 m between the axles. */
  static Kinematics ackermann() {
    return percent -> {
      double mps = 0.03 * percent.applyAsDouble("THROTTLE");
      double angle = Math.toRadians(-0.28 * percent.applyAsDouble("STEERING"));
      return new Drive(mps, mps * Math.tan(angle) / 0.6);
    };
  }

  void step(double dtS, ToDoubleFunction<String> percent) {
    Drive wanted = kinematics.drive(percent);
    double share = dtS / (lagS + dtS);
    speed += share * (wanted.speedMps() - speed);
    yawRate += share * (wanted.yawRateRadPerS() - yawRate);
    heading -= yawRate * dtS;
    north += speed * Math.cos(heading) * dtS;
    east += speed * Math.sin(heading) * dtS;
  }

  StateInformation measured() {
    Geodetic place =
        ORIGIN.fromNed(
            Point.of(
                north + POSITION_NOISE_M * random.nextDouble(-1.7, 1.7),
                east + POSITION_NOISE_M * random.nextDouble(-1.7, 1.7),
                0.0));
    return new StateInformation()
        .x(place.longitudeDeg())
        .y(place.latitudeDeg())
        .xDot(speed * Math.sin(heading))
        .yDot(speed * Math.cos(heading))
        .psi(heading + headingErrorRad + HEADING_NOISE_RAD * random.nextDouble(-1.7, 1.7));
  }
}
