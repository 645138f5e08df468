package org.u2sa.sim.marine;

import org.u2sa.sim.motion.Arguments;

/**
 * Lift and drag of a submerged slender hull by angle of attack, as a wing of low aspect ratio
 * (Fossen 2021, section 8.4.2; Beard and McLain, Small Unmanned Aircraft, section 4.2): C_L = C_Lα
 * α with C_Lα = π A / (1 + √(1 + (A/2)²)), C_D = C_D0 + C_L² / (π e A). Likewise astern.
 *
 * @param areaM2 reference area [m²]
 * @param spanM breadth of the hull [m]
 * @param parasiticDrag C_D0
 * @param efficiency Oswald's e
 * @param densityKgPerM3 water density [kg/m³]
 */
public record HullLift(
    double areaM2, double spanM, double parasiticDrag, double efficiency, double densityKgPerM3) {
  /**
   * @throws IllegalArgumentException if a value is not above 0
   */
  public HullLift {
    Arguments.requirePositive("area of the hull [m^2]", areaM2);
    Arguments.requirePositive("span of the hull [m]", spanM);
    Arguments.requirePositive("parasitic drag", parasiticDrag);
    Arguments.requirePositive("efficiency", efficiency);
    Arguments.requirePositive("density [kg/m^3]", densityKgPerM3);
  }

  /** Adds the force at a velocity through the water [m/s] to six forces. */
  void act(double u, double v, double w, double[] force) {
    double alpha = StrictMath.atan2(w, StrictMath.abs(u));
    double ratio = spanM * spanM / areaM2;
    double slope = StrictMath.PI * ratio / (1.0 + StrictMath.sqrt(1.0 + ratio * ratio / 4.0));
    double cl = slope * alpha;
    double cd = parasiticDrag + cl * cl / (StrictMath.PI * efficiency * ratio);
    double pressure = 0.5 * densityKgPerM3 * (u * u + v * v + w * w) * areaM2;
    double sin = StrictMath.sin(alpha);
    double cos = StrictMath.cos(alpha);
    force[0] += StrictMath.signum(u) * pressure * (sin * cl - cos * cd);
    force[2] -= pressure * (sin * cd + cos * cl);
  }
}
