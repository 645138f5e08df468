package org.u2sa.sim.world;

import org.u2sa.sim.motion.Arguments;

/**
 * A body of water without waves; its bed is the terrain.
 *
 * @param surfaceM surface height above the world's plane [m]
 * @param currentEastMps east velocity of the water [m/s]
 * @param currentNorthMps north velocity of the water [m/s]
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

  /** Depth of a point below the surface [m]; negative above it. */
  public double depthM(double upM) {
    return surfaceM - upM;
  }
}
