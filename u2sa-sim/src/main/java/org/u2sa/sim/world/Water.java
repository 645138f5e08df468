package org.u2sa.sim.world;

import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * A body of water; its bed is the terrain.
 *
 * @param surfaceM height of the still surface above the world's plane [m]
 * @param current velocity of the water
 * @param waves waves on the surface; empty: none
 */
public record Water(double surfaceM, CurrentField current, Optional<Waves> waves) {
  /**
   * @throws IllegalArgumentException if a value is not a number
   */
  public Water {
    Arguments.requireFinite("water surface", surfaceM);
  }

  /**
   * Water with the same current everywhere and no waves.
   *
   * @param currentEastMps east velocity of the water [m/s]
   * @param currentNorthMps north velocity of the water [m/s]
   * @throws IllegalArgumentException if a value is outside its range
   */
  public Water(double surfaceM, double currentEastMps, double currentNorthMps) {
    this(surfaceM, CurrentField.uniform(currentEastMps, currentNorthMps), Optional.empty());
  }

  /** Depth of a point below the still surface [m]; negative above it. */
  public double depthM(double upM) {
    return surfaceM - upM;
  }

  /** Velocity of the water at a point [east, north, up], without waves: east, north, 0 [m/s]. */
  public Point currentAt(Point place) {
    return current.at(place.x(), place.y(), Math.max(0.0, depthM(place.z())));
  }

  /** Elevation of the waves above the still surface [m]. */
  public double waveM(double eastM, double northM, double timeS) {
    return waves.map(all -> all.elevationM(eastM, northM, timeS)).orElse(0.0);
  }

  /**
   * Pressure at a point [east, north, up] as a head of water [m]: its depth plus the part of the
   * wave pressure that reaches it; negative in the air.
   */
  public double headM(Point place, double timeS) {
    double depth = depthM(place.z());
    return waves
        .map(all -> depth + all.headM(place.x(), place.y(), Math.max(0.0, depth), timeS))
        .orElse(depth);
  }
}
