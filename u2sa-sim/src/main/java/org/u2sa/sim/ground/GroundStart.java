package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/**
 * Initial pose of a ground vehicle.
 *
 * @param eastM on the local plane [m]
 * @param northM on the local plane [m]
 * @param headingRad clockwise from true north [rad]
 */
public record GroundStart(double eastM, double northM, double headingRad) {
  /**
   * @throws IllegalArgumentException if one is not a number
   */
  public GroundStart {
    Arguments.requireFinite("east", eastM);
    Arguments.requireFinite("north", northM);
    Arguments.requireFinite("heading", headingRad);
  }

  /** At the origin, facing north. */
  public static GroundStart atOrigin() {
    return new GroundStart(0.0, 0.0, 0.0);
  }
}
