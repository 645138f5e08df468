package org.u2sa.sim.gear;

import org.u2sa.sim.motion.Arguments;

/**
 * Contact of one wheel or skid with the ground.
 *
 * @param stiffness longitudinal and lateral [N/m]
 * @param damping damping of the patch's deflection [N s/m]
 * @param grip coefficient of friction across the wheel
 * @param rolling coefficient of friction along the wheel without brakes; a skid's is its grip
 * @param brakeGrip coefficient of friction that a full brake adds along the wheel
 * @param relaxationM distance over which the lateral deflection builds up while rolling [m]
 */
public record Tyre(
    double stiffness,
    double damping,
    double grip,
    double rolling,
    double brakeGrip,
    double relaxationM) {
  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public Tyre {
    Arguments.requirePositive("stiffness of a tyre [N/m]", stiffness);
    Arguments.requireInside("damping of a tyre [N s/m]", damping, 0.0, 1e6);
    Arguments.requireInside("grip of a tyre", grip, 0.0, 3.0);
    Arguments.requireInside("rolling resistance of a tyre", rolling, 0.0, 3.0);
    Arguments.requireInside("brake grip of a tyre", brakeGrip, 0.0, 3.0);
    Arguments.requirePositive("relaxation length of a tyre [m]", relaxationM);
  }
}
