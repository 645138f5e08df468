package org.u2sa.sim.ground;

/**
 * Ground-truth state of a ground vehicle at its reference point, the centre of the driven axle.
 *
 * @param timeS simulated time since the start [s]
 * @param eastM on the local plane [m]
 * @param northM on the local plane [m]
 * @param headingRad clockwise from north [rad, 0…2π)
 * @param forwardMps speed of the reference point along the vehicle [m/s]
 * @param rightMps lateral speed of the reference point [m/s]: sideslip
 * @param yawRateRadPerS clockwise positive [rad/s]
 * @param leftWheelRadPerS forward positive [rad/s]; with Ackermann steering both report the axle
 * @param rightWheelRadPerS forward positive [rad/s]
 * @param leftWheelRad rotation since the start [rad]
 * @param rightWheelRad rotation since the start [rad]
 * @param steerRad steering angle, right positive [rad]; 0 without steering
 * @param leftMotorA current through the left, or only, motor, driving forward positive [A]
 * @param rightMotorA [A]; 0 if there is only one motor
 * @param batteryV voltage at the battery's terminals [V]
 * @param charge battery state of charge, 0…1
 */
public record GroundState(
    double timeS,
    double eastM,
    double northM,
    double headingRad,
    double forwardMps,
    double rightMps,
    double yawRateRadPerS,
    double leftWheelRadPerS,
    double rightWheelRadPerS,
    double leftWheelRad,
    double rightWheelRad,
    double steerRad,
    double leftMotorA,
    double rightMotorA,
    double batteryV,
    double charge) {

  /** East velocity [m/s]. */
  public double eastMps() {
    return forwardMps * StrictMath.sin(headingRad) + rightMps * StrictMath.cos(headingRad);
  }

  /** North velocity [m/s]. */
  public double northMps() {
    return forwardMps * StrictMath.cos(headingRad) - rightMps * StrictMath.sin(headingRad);
  }

  /** Speed over ground [m/s]. */
  public double speedMps() {
    return StrictMath.sqrt(forwardMps * forwardMps + rightMps * rightMps);
  }
}
