package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/**
 * Tyre parameters of the single-contact-point model (Pacejka, Tire and Vehicle Dynamics, chapter
 * 7), equal in both directions.
 *
 * @param slipStiffness force per load and slip, longitudinal [1] and lateral [1/rad]
 * @param relaxationM relaxation length [m]
 * @param dampingS damping of the static tyre: force per deflection rate over force per deflection
 *     [s]
 * @param patchRadiusM radius of the contact patch, modelled as a disc [m]; causes scrub in turns
 */
public record TyreParameters(
    double slipStiffness, double relaxationM, double dampingS, double patchRadiusM) {
  /**
   * @throws IllegalArgumentException if a value is not above 0
   */
  public TyreParameters {
    Arguments.requirePositive("slip stiffness", slipStiffness);
    Arguments.requirePositive("relaxation length", relaxationM);
    Arguments.requirePositive("tyre damping", dampingS);
    Arguments.requirePositive("contact patch radius", patchRadiusM);
  }

  /**
   * A soft pneumatic wheel of about 0.2 m diameter: stiffness 10 per load is at the lower end of
   * Pacejka's car tyres; relaxation length is half a wheel radius; the patch is estimated.
   */
  public static TyreParameters wheelbarrow() {
    return new TyreParameters(10.0, 0.05, 0.01, 0.02);
  }
}
