package org.u2sa.sim.camera;

import java.util.Random;
import org.u2sa.sim.motion.Arguments;

/**
 * Lighting conditions.
 *
 * @param sunAzimuthRad azimuth of the sun, clockwise from north [rad]
 * @param sunElevationRad above the horizon [rad], 0.05…1.5
 * @param sun direct-sun contribution to ground brightness; 0 when overcast
 * @param sky brightness of shaded ground
 * @param cloudShadows fraction of the ground in the shade of clouds and trees, 0…1
 * @param glare lens glare towards the sun, 0 none … 1 blinding
 * @param warmth tint: −1 blue to 1 red
 */
public record Light(
    double sunAzimuthRad,
    double sunElevationRad,
    double sun,
    double sky,
    double cloudShadows,
    double glare,
    double warmth) {
  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public Light {
    Arguments.requireFinite("azimuth of the sun", sunAzimuthRad);
    Arguments.requireInside("elevation of the sun", sunElevationRad, 0.05, 1.5);
    Arguments.requireInside("sunlight", sun, 0.0, 10.0);
    Arguments.requireInside("skylight", sky, 0.01, 10.0);
    Arguments.requireInside("share of cloud shadows", cloudShadows, 0.0, 1.0);
    Arguments.requireInside("glare", glare, 0.0, 1.0);
    Arguments.requireInside("warmth", warmth, -1.0, 1.0);
  }

  /** A bright day with thin clouds and no shadows. */
  public static Light even() {
    return new Light(0.0, 0.9, 0.0, 1.0, 0.0, 0.0, 0.0);
  }

  /** A clear noon in early June. */
  public static Light clear() {
    return new Light(3.3, 1.1, 0.75, 0.25, 0.0, 0.1, 0.1);
  }

  /** Random conditions, from overcast to low sun through trees. */
  public static Light random(Random by) {
    boolean clear = by.nextDouble() < 0.7;
    double sun = clear ? 0.5 + 0.35 * by.nextDouble() : 0.2 * by.nextDouble();
    return new Light(
        2.0 * Math.PI * by.nextDouble(),
        0.35 + 0.85 * by.nextDouble(),
        sun,
        clear ? 0.2 + 0.15 * by.nextDouble() : 0.6 + 0.4 * by.nextDouble(),
        clear ? 0.3 * by.nextDouble() : 0.0,
        clear ? 0.5 * by.nextDouble() : 0.1 * by.nextDouble(),
        0.6 * (by.nextDouble() - 0.3));
  }
}
