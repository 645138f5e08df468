package org.u2sa.sim.marine;

import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * Rigid-body and hydrodynamic parameters about the reference point, in forward, right, down axes.
 * Points hold one value per axis.
 *
 * @param massKg mass [kg]
 * @param inertia moments of inertia about the reference point [kg m²]
 * @param addedMass added mass, linear: −X_u̇, −Y_v̇, −Z_ẇ [kg]
 * @param addedInertia added inertia, angular: −K_ṗ, −M_q̇, −N_ṙ [kg m²]
 * @param drag linear damping: −X_u, −Y_v, −Z_w [N s/m]
 * @param angularDrag linear angular damping: −K_p, −M_q, −N_r [N m s]
 * @param squareDrag quadratic damping: −X_|u|u, … [N s²/m²]
 * @param squareAngularDrag quadratic angular damping: −K_|p|p, … [N m s²]
 * @param gravityCentre centre of gravity [m]
 * @param buoyancyCentre centre of buoyancy [m]
 * @param buoyancyN buoyancy of the submerged hull [N]
 * @param heightM hull height [m], half of it above the reference point; used for buoyancy at the
 *     surface
 * @param waterplane restoring forces of a hull that stays at the surface, instead of weight,
 *     buoyancy and height
 * @param crossFlow drag of a slender hull; empty: none
 * @param lift lift and drag of a submerged slender hull; empty: none
 * @param dragFade decay of the linear damping with the speed U through the water, exp(−fade · U),
 *     where quadratic terms take over [s/m]; 0: none
 * @param hasMunkMoment whether added mass couples linear velocity into pitch and yaw, which turns a
 *     slender hull across its motion; models without the balancing damping omit this
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
    double heightM,
    Optional<Waterplane> waterplane,
    Optional<CrossFlow> crossFlow,
    Optional<HullLift> lift,
    Point dragFade,
    boolean hasMunkMoment) {
  /**
   * @throws IllegalArgumentException if a mass or the height is not above 0
   */
  public Hull {
    Arguments.requirePositive("mass [kg]", massKg);
    Arguments.requirePositive("height of the hull [m]", heightM);
    Arguments.requireFinite("buoyancy [N]", buoyancyN);
  }
}
