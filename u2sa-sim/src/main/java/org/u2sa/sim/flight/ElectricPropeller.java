package org.u2sa.sim.flight;

import org.u2sa.sim.motion.Arguments;

/**
 * An electric motor with a propeller ahead of the centre of gravity, in equilibrium: Beard and
 * McLain, Small Unmanned Aircraft, section 4.3 of the supplement.
 *
 * @param name name used in commands
 * @param diameterM diameter of the propeller [m]
 * @param thrust coefficients C_T0, C_T1, C_T2 of the advance ratio's powers
 * @param torque coefficients C_Q0, C_Q1, C_Q2 of the advance ratio's powers
 * @param voltPerRadPerS back-EMF constant K_V, which is also the torque constant [V s/rad, N m/A]
 * @param resistanceOhm of the motor [Ω]
 * @param idleA current without load [A]
 * @param maxV voltage at full throttle [V]
 * @param timeConstantS time constant of the throttle [s]
 */
public record ElectricPropeller(
    String name,
    double diameterM,
    Quadratic thrust,
    Quadratic torque,
    double voltPerRadPerS,
    double resistanceOhm,
    double idleA,
    double maxV,
    double timeConstantS) {
  private static final double TURN = 2.0 * StrictMath.PI;
  private static final double SLOWEST_RADPS = 1e-3;

  /**
   * A polynomial a + b x + c x².
   *
   * @param a constant
   * @param b linear coefficient
   * @param c quadratic coefficient
   */
  public record Quadratic(double a, double b, double c) {
    double at(double x) {
      return a + (b + c * x) * x;
    }
  }

  /**
   * @throws IllegalArgumentException if a value is out of range
   */
  public ElectricPropeller {
    Arguments.requirePositive("diameter of " + name + " [m]", diameterM);
    Arguments.requirePositive("static thrust coefficient of " + name, thrust.a());
    Arguments.requirePositive("static torque coefficient of " + name, torque.a());
    Arguments.requirePositive("back-EMF constant of " + name, voltPerRadPerS);
    Arguments.requirePositive("resistance of " + name + " [Ω]", resistanceOhm);
    Arguments.requireInside("idle current of " + name + " [A]", idleA, 0.0, 1_000.0);
    Arguments.requirePositive("voltage of " + name + " [V]", maxV);
    Arguments.requireInside("time constant of " + name + " [s]", timeConstantS, 0.005, 10.0);
  }

  /**
   * Speed at which motor and propeller torque are equal [rad/s]; 0 if the motor cannot turn it.
   *
   * @param throttle 0…1
   * @param airspeedMps along the axis [m/s]
   */
  double speedRadPerS(double throttle, double airspeedMps, double densityKgPerM3) {
    double d3 = diameterM * diameterM * diameterM;
    double volt = maxV * throttle;
    double a = torque.a() * densityKgPerM3 * d3 * diameterM * diameterM / (TURN * TURN);
    double b =
        torque.b() * densityKgPerM3 * d3 * diameterM * airspeedMps / TURN
            + voltPerRadPerS * voltPerRadPerS / resistanceOhm;
    double c =
        torque.c() * densityKgPerM3 * d3 * airspeedMps * airspeedMps
            - voltPerRadPerS * (volt / resistanceOhm - idleA);
    double root = b * b - 4.0 * a * c;
    double speed = root > 0.0 ? (-b + StrictMath.sqrt(root)) / (2.0 * a) : 0.0;
    return StrictMath.max(0.0, speed);
  }

  /** Electrical power of the motor [W]; 0 while the propeller would drive the motor. */
  double powerW(double throttle, double airspeedMps, double densityKgPerM3) {
    double volt = maxV * throttle;
    double speed = speedRadPerS(throttle, airspeedMps, densityKgPerM3);
    return volt * StrictMath.max(0.0, (volt - voltPerRadPerS * speed) / resistanceOhm);
  }

  /** Thrust at a speed [N]; negative if it brakes. */
  double thrustN(double speedRadPerS, double airspeedMps, double densityKgPerM3) {
    return pressure(speedRadPerS, densityKgPerM3) * thrust.at(advance(speedRadPerS, airspeedMps));
  }

  /** Torque on the motor at a speed [N m]. */
  double torqueNm(double speedRadPerS, double airspeedMps, double densityKgPerM3) {
    return pressure(speedRadPerS, densityKgPerM3)
        * diameterM
        * torque.at(advance(speedRadPerS, airspeedMps));
  }

  private double advance(double speedRadPerS, double airspeedMps) {
    return TURN * airspeedMps / (StrictMath.max(SLOWEST_RADPS, speedRadPerS) * diameterM);
  }

  private double pressure(double speedRadPerS, double densityKgPerM3) {
    double perS = StrictMath.max(SLOWEST_RADPS, speedRadPerS) / TURN;
    double d2 = diameterM * diameterM;
    return densityKgPerM3 * perS * perS * d2 * d2;
  }
}
