package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/**
 * Something that the vehicle carries, as a point mass.
 *
 * @param massKg [kg], 0 for none
 * @param aheadM ahead of the driven axle [m]
 * @param rightM right of the middle [m]; a single-track model does not feel it
 */
public record Payload(double massKg, double aheadM, double rightM) {
  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public Payload {
    Arguments.requireInside("payload mass", massKg, 0.0, 1_000.0);
    Arguments.requireFinite("payload ahead", aheadM);
    Arguments.requireFinite("payload right", rightM);
  }

  /** Nothing. */
  public static Payload none() {
    return new Payload(0.0, 0.0, 0.0);
  }
}
