package org.u2sa.sim.marine;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * Linear restoring forces of a hull that floats at the surface, about its equilibrium with the
 * reference point in the waterline (Fossen 2021, equations 4.19–4.27).
 *
 * @param heaveNPerM stiffness in heave, ρ g A_wp [N/m]
 * @param rollNmPerRad stiffness in roll about the centre of flotation, ρ g ∇ GM_T [N m/rad]
 * @param pitchNmPerRad stiffness in pitch about the centre of flotation, ρ g ∇ GM_L [N m/rad]
 * @param centreAheadM centre of flotation ahead of the reference point [m]
 * @param ballastKg mass whose weight trims the hull, part of the hull's mass [kg]; 0: none
 * @param ballast position of that mass [m]
 */
public record Waterplane(
    double heaveNPerM,
    double rollNmPerRad,
    double pitchNmPerRad,
    double centreAheadM,
    double ballastKg,
    Point ballast) {
  /**
   * @throws IllegalArgumentException if a stiffness is not above 0
   */
  public Waterplane {
    Arguments.requirePositive("heave stiffness [N/m]", heaveNPerM);
    Arguments.requirePositive("roll stiffness [N m/rad]", rollNmPerRad);
    Arguments.requirePositive("pitch stiffness [N m/rad]", pitchNmPerRad);
    Arguments.requireInside("ballast [kg]", ballastKg, 0.0, 1e9);
  }
}
