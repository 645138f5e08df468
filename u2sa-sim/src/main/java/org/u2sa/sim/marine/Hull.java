package org.u2sa.sim.marine;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * The rigid body and the water around it, about its reference point, in forward, right and down
 * axes. Points hold one number for each axis.
 *
 * @param massKg [kg]
 * @param inertia about the axes through the reference point [kg m²]
 * @param addedMass of the water, linear: −X_u̇, −Y_v̇, −Z_ẇ [kg]
 * @param addedInertia of the water, angular: −K_ṗ, −M_q̇, −N_ṙ [kg m²]
 * @param drag linear: −X_u, −Y_v, −Z_w [N s/m]
 * @param angularDrag linear: −K_p, −M_q, −N_r [N m s]
 * @param squareDrag quadratic: −X_|u|u, … [N s²/m²]
 * @param squareAngularDrag quadratic: −K_|p|p, … [N m s²]
 * @param gravityCentre [m]
 * @param buoyancyCentre [m]
 * @param buoyancyN of the submerged hull [N]
 * @param heightM of the hull, half of it above the reference point, for the buoyancy at the surface
 *     [m]
 */
public record Hull(
    double massKg,
    Point inertia,
    Point addedMass,
    Point addedInertia,
    Point drag,
    Point angularDrag,
    Point squareDrag,
    Point squareAngularDrag,
    Point gravityCentre,
    Point buoyancyCentre,
    double buoyancyN,
    double heightM) {
  /**
   * @throws IllegalArgumentException if a mass or the height is not above 0
   */
  public Hull {
    Arguments.requirePositive("mass [kg]", massKg);
    Arguments.requirePositive("height of the hull [m]", heightM);
    Arguments.requireFinite("buoyancy [N]", buoyancyN);
  }
}
