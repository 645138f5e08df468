package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/**
 * A payload, modelled as a point mass.
 *
 * @param massKg mass [kg], 0 for none
 * @param aheadM position ahead of the driven axle [m]
 * @param rightM position right of the centre line [m]; ignored by single-track models
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

  /** No payload. */
  public static Payload none() {
    return new Payload(0.0, 0.0, 0.0);
  }
}
