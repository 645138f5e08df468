package org.u2sa.core.control.cascade;

import org.u2sa.core.control.Pid;

/**
 * How one degree of freedom is controlled.
 *
 * @param weight where actuators cannot do all; 0: not controlled
 * @param mass [kg], or moment of inertia [kg m²]
 * @param gains of the inner loop, acceleration by error of velocity or rate
 * @param outerGain velocity by distance, or rate by angle [1/s]
 * @param fastest velocity [m/s] or rate [rad/s]
 */
record AxisTuning(double weight, double mass, Pid.Gains gains, double outerGain, double fastest) {
  boolean isControlled() {
    return weight > 0.0;
  }

  /** The velocity or rate that takes an error of place or angle out. */
  double towards(double error) {
    return Math.max(-fastest, Math.min(fastest, outerGain * error));
  }
}
