package org.u2sa.sim.marine;

import org.u2sa.sim.motion.Arguments;

/**
 * Sway force and yaw moment of a slender hull that moves sideways, by strip theory (Fossen 2021,
 * equations 6.90 and 6.91), over 20 strips.
 *
 * @param lengthM length of the hull, half of it ahead of the reference point [m]
 * @param draughtM draught [m]
 * @param coefficient two-dimensional drag coefficient, from Hoerner's curve
 * @param densityKgPerM3 water density [kg/m³]
 */
public record CrossFlow(
    double lengthM, double draughtM, double coefficient, double densityKgPerM3) {
  private static final int STRIPS = 20;

  /**
   * @throws IllegalArgumentException if a value is not above 0
   */
  public CrossFlow {
    Arguments.requirePositive("length [m]", lengthM);
    Arguments.requirePositive("draught [m]", draughtM);
    Arguments.requirePositive("cross-flow coefficient", coefficient);
    Arguments.requirePositive("density [kg/m^3]", densityKgPerM3);
  }

  /** Subtracts the drag at a sway velocity [m/s] and yaw rate [rad/s] from six forces. */
  void drag(double v, double r, double[] force) {
    double stripM = lengthM / STRIPS;
    double each = 0.5 * densityKgPerM3 * draughtM * coefficient * stripM;
    for (int i = 0; i < STRIPS; i++) {
      double x = (i + 0.5) * stripM - lengthM / 2.0;
      double speed = v + x * r;
      double newtons = each * StrictMath.abs(speed) * speed;
      force[1] -= newtons;
      force[5] -= x * newtons;
    }
  }
}
