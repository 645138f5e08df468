package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/**
 * Brushed gear motor from data-sheet values at the output shaft, and its controller's dead band.
 *
 * @param ratedV voltage at which the figures below apply [V]
 * @param freeRadPerS speed without load [rad/s]
 * @param freeA current without load [A]
 * @param stallNm torque at standstill [N m]
 * @param stallA current at standstill [A]
 * @param inertiaKgM2 inertia of rotor and gears at the output shaft [kg m²]
 * @param deadBand commands up to this magnitude are neutral, 0…1
 */
public record MotorParameters(
    double ratedV,
    double freeRadPerS,
    double freeA,
    double stallNm,
    double stallA,
    double inertiaKgM2,
    double deadBand) {
  private static final double RADPERS_PER_RPM = Math.PI / 30.0;

  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public MotorParameters {
    Arguments.requirePositive("rated voltage", ratedV);
    Arguments.requirePositive("free speed", freeRadPerS);
    Arguments.requirePositive("stall torque", stallNm);
    Arguments.requirePositive("stall current", stallA);
    Arguments.requireInside("free current", freeA, 0.0, stallA);
    Arguments.requirePositive("inertia", inertiaKgM2);
    Arguments.requireInside("dead band", deadBand, 0.0, 0.5);
    double efficiency = stallNm / (stallA * (ratedV - freeA * ratedV / stallA) / freeRadPerS);
    Arguments.requireInside("stall torque by stall current and back EMF", efficiency, 0.1, 1.0);
  }

  /**
   * AndyMark PG27 (RS-775 motor, 27:1): 198 rpm, 0.6 A, 8.54 N m, 22 A at 12 V. Inertia estimated
   * for a rotor of that size, 1.5e-5 kg m² times 27². Dead band: 4 %, as in the manuals of hobby
   * and FIRST motor controllers (Victor SP, Talon SR).
   */
  public static MotorParameters pg27() {
    return new MotorParameters(12.0, 198.0 * RADPERS_PER_RPM, 0.6, 8.541, 22.0, 0.011, 0.04);
  }

  /** Winding resistance [Ω]. */
  double resistanceOhm() {
    return ratedV / stallA;
  }

  /**
   * Motor constant: back EMF per speed [V s/rad], and torque per current before gear friction [N
   * m/A].
   */
  double constant() {
    return (ratedV - freeA * resistanceOhm()) / freeRadPerS;
  }

  /** Gear efficiency: data-sheet stall torque relative to the torque from stall current. */
  double efficiency() {
    return stallNm / (stallA * constant());
  }

  /** No-load gear friction torque [N m]. */
  double dragNm() {
    return constant() * freeA * efficiency();
  }

  /** Duty cycle for a command. */
  double duty(double command) {
    return Math.abs(command) <= deadBand ? 0.0 : command;
  }
}
