package org.u2sa.control.cascade;

import org.u2sa.control.Pid;

/**
 * Control settings of one degree of freedom.
 *
 * @param weight allocation weight when actuators saturate; 0 if not controlled
 * @param mass mass [kg], or moment of inertia [kg m²]
 * @param gains gains of the inner loop: acceleration per error of velocity or rate
 * @param outerGain velocity per distance, or rate per angle [1/s]
 * @param fastest maximum velocity [m/s] or rate [rad/s]
 */
record AxisTuning(double weight, double mass, Pid.Gains gains, double outerGain, double fastest) {
  /** How many times faster than the derivative time its filter is. */
  private static final double DERIVATIVE_FILTER = 10.0;

  /** Gains of an inner loop, with the times in seconds. */
  static Pid.Gains gains(double gain, double integralTime, double derivativeTime) {
    return new Pid.Gains(gain, integralTime, derivativeTime, DERIVATIVE_FILTER, 1.0);
  }

  boolean isControlled() {
    return weight > 0.0;
  }

  /** Velocity or rate to correct an error of position or angle. */
  double towards(double error) {
    return Math.max(-fastest, Math.min(fastest, outerGain * error));
  }
}
