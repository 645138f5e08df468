package org.u2sa.sim.camera;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.ObjectDescription;

/**
 * Visual model of open water: its surface to the horizon, the sky, the floor, and objects above and
 * below the surface, in the colours of {@code messages.marine}; other solids are grey. Immutable
 * and shareable between cameras.
 */
public final class WaterScenery {
  final List<Solid> solids;
  final WaterLook look;
  final Light light;
  final float[] sun; // unit vector towards the sun: east, north, up
  final WaveSlopes waves;
  final ValueNoise noise;

  /**
   * @param objects in LOCAL_ENU
   * @param seed random seed of waves, floor and particles
   */
  public WaterScenery(
      List<? extends ObjectDescription> objects, WaterLook look, Light light, long seed) {
    this.look = look;
    this.light = light;
    double level = StrictMath.cos(light.sunElevationRad());
    sun =
        new float[] {
          (float) (level * StrictMath.sin(light.sunAzimuthRad())),
          (float) (level * StrictMath.cos(light.sunAzimuthRad())),
          (float) StrictMath.sin(light.sunElevationRad())
        };
    List<Solid> all = new ArrayList<>();
    objects.forEach(object -> all.addAll(MarineShapes.of(object)));
    solids = List.copyOf(all);
    waves = new WaveSlopes(look.slopeVariance(), seed);
    noise = new ValueNoise(seed);
  }

  /** Light on a level white surface just above the water. */
  float daylight() {
    return (float) (light.sky() + light.sun() * sun[2]);
  }
}
