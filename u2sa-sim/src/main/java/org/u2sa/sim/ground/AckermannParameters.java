package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/**
 * Single-track parameters of a vehicle with a driven rear axle and steered front wheels.
 *
 * @param massKg mass without payload [kg]
 * @param yawInertiaKgM2 without payload, about its own centre of gravity [kg m²]
 * @param cogAheadM centre of gravity ahead of the rear axle, without payload [m]
 * @param cogHeightM height of the centre of gravity, with and without payload [m]
 * @param wheelbaseM [m]
 * @param wheelRadiusM [m]
 * @param wheelInertiaKgM2 rotating inertia of the rear axle without motor [kg m²]
 * @param steerMaxRad steering angle at full command [rad]
 * @param steerLagS time constant of the servo [s]
 * @param steerRateRadPerS maximum steering rate [rad/s]
 */
public record AckermannParameters(
    double massKg,
    double yawInertiaKgM2,
    double cogAheadM,
    double cogHeightM,
    double wheelbaseM,
    double wheelRadiusM,
    double wheelInertiaKgM2,
    double steerMaxRad,
    double steerLagS,
    double steerRateRadPerS,
    MotorParameters motor,
    TyreParameters tyre,
    BatteryParameters battery,
    Payload payload) {
  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public AckermannParameters {
    Arguments.requirePositive("mass", massKg);
    Arguments.requirePositive("yaw inertia", yawInertiaKgM2);
    Arguments.requirePositive("wheelbase", wheelbaseM);
    Arguments.requireInside("centre of gravity ahead", cogAheadM, 0.0, wheelbaseM);
    Arguments.requireInside("height of the centre of gravity", cogHeightM, 0.0, 2.0);
    Arguments.requirePositive("wheel radius", wheelRadiusM);
    Arguments.requirePositive("wheel inertia", wheelInertiaKgM2);
    Arguments.requireInside("steering angle", steerMaxRad, 0.01, 1.2);
    Arguments.requirePositive("steering lag", steerLagS);
    Arguments.requirePositive("steering rate", steerRateRadPerS);
  }
}
