package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/**
 * A tyre on the ground as the single contact point model has it (Pacejka, Tire and Vehicle
 * Dynamics, chapter 7), alike in both directions.
 *
 * @param slipStiffness force by load and slip, along [1] and across [1/rad]
 * @param relaxationM way on which the force builds up [m]
 * @param dampingS of the standing tyre: force of a stretch rate, by that of a stretch [s]
 * @param patchRadiusM of the contact, taken as a disc [m]: it scrubs when the vehicle turns
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
   * A soft pneumatic wheel of about 0.2 m diameter: stiffness 10 by load is at the lower end of
   * Pacejka's car tyres, relaxation is half a wheel radius, the patch is estimated.
   */
  public static TyreParameters wheelbarrow() {
    return new TyreParameters(10.0, 0.05, 0.01, 0.02);
  }

  /**
   * A tyre of a 1:10 truck: cornering stiffness 5.0 by load, the mean of front and rear (4.7, 5.5)
   * that F1TENTH's simulator uses by grip; relaxation is half a wheel radius.
   */
  public static TyreParameters truck() {
    return new TyreParameters(5.0, 0.028, 0.01, 0.012);
  }
}
