package org.u2sa.sim.world;

import org.u2sa.sim.motion.Arguments;

/**
 * A body of water without waves; its bed is the terrain.
 *
 * @param surfaceM height of its surface on the world's plane [m]
 * @param currentEastMps velocity of the water [m/s]
 * @param currentNorthMps velocity of the water [m/s]
 */
public record Water(double surfaceM, double currentEastMps, double currentNorthMps) {
  /**
   * @throws IllegalArgumentException if a value is not a number
   */
  public Water {
    Arguments.requireFinite("water surface", surfaceM);
    Arguments.requireInside("current east [m/s]", currentEastMps, -20.0, 20.0);
    Arguments.requireInside("current north [m/s]", currentNorthMps, -20.0, 20.0);
  }

  /** Depth of a place below the surface [m]; negative above it. */
  public double depthM(double upM) {
    return surfaceM - upM;
  }
}
