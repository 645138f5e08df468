package org.u2sa.sim.flight;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * Mass and inertia of a rigid body that is symmetric about its x–z plane, in forward, right, down
 * axes about the centre of gravity.
 *
 * @param massKg mass [kg]
 * @param inertia moments of inertia about the three axes [kg m²]
 * @param productXz product of inertia J_xz [kg m²]
 */
public record MassProperties(double massKg, Point inertia, double productXz) {
  /**
   * @throws IllegalArgumentException if no body has these values
   */
  public MassProperties {
    Arguments.requirePositive("mass [kg]", massKg);
    Arguments.requirePositive("moment of inertia about the forward axis [kg m²]", inertia.x());
    Arguments.requirePositive("moment of inertia about the right axis [kg m²]", inertia.y());
    Arguments.requirePositive("moment of inertia about the down axis [kg m²]", inertia.z());
    double limit = StrictMath.sqrt(inertia.x() * inertia.z());
    if (!(StrictMath.abs(productXz) < limit)) {
      throw new IllegalArgumentException(
          "product of inertia J_xz [kg m²]: " + productXz + " is not between ±" + limit);
    }
  }
}
