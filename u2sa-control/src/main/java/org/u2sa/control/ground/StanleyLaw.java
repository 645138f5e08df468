package org.u2sa.control.ground;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/**
 * Steers front wheels along a path by the heading error and the cross-track error of the front
 * axle, δ = ψ_path − ψ + arctan(k e / (k_soft + v)) − k_yaw (r − r_path).
 *
 * <p>Hoffmann, Tomlin, Montemerlo, Thrun: Autonomous Automobile Trajectory Tracking for Off-Road
 * Driving, ACC 2007, equation 5 (Stanley, Thrun et al., J. Field Robotics 23 (2006) 9).
 */
final class StanleyLaw {
  /** Gains. */
  record Variables(
      @Variable(unit = "1/s", min = 0.01, max = 20, ifAbsent = 2)
          @Description("Rate at which a small cross-track error decays.")
          double crossTrackGain,
      @Variable(unit = "m/s", min = 0, max = 10, ifAbsent = 0.3)
          @Description("Softening speed, which limits the gain at low speed.")
          double softening,
      @Variable(unit = "s", min = 0, max = 2, ifAbsent = 0)
          @Description("Damping: steering per yaw-rate deviation from the path.")
          double yawDamping) {}

  private StanleyLaw() {}

  /**
   * Angle of the front wheels [rad], left positive.
   *
   * @param headingErrorRad heading of the path relative to the vehicle, positive if the path points
   *     left
   * @param rightOfPathM distance of the front axle's centre to the right of the path
   * @param speedMps forward speed
   * @param yawRateErrorRadPerS measured yaw rate minus the path's, left positive
   */
  static double steeringRad(
      Variables tuning,
      double headingErrorRad,
      double rightOfPathM,
      double speedMps,
      double yawRateErrorRadPerS) {
    double towards =
        Math.atan2(
            tuning.crossTrackGain() * rightOfPathM,
            Math.max(1e-3, tuning.softening() + Math.abs(speedMps)));
    return headingErrorRad + towards - tuning.yawDamping() * yawRateErrorRadPerS;
  }
}
