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
  boolean isControlled() {
    return weight > 0.0;
  }

  /** Velocity or rate to correct an error of position or angle. */
  double towards(double error) {
    return Math.max(-fastest, Math.min(fastest, outerGain * error));
  }
}
