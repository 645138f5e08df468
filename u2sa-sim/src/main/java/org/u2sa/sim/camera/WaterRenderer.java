package org.u2sa.sim.camera;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Renders the view of a camera above or below water with one ray per pixel, then applies lens and
 * sensor effects ({@link Development}). The shutter is global. Bands of rows run on all cores with
 * separate buffers, so the image does not depend on their number. Not thread-safe.
 */
public final class WaterRenderer {
  private static final int BANDS = 8;

  private final ColourLens lens;
  private final WaterScenery scenery;
  private final RayTable rays;
  private final float[] light; // linear red, green, blue per pixel
  private final Development development;
  private final Development.Bath[] baths = new Development.Bath[BANDS];
  private final WaterRays[] tracers = new WaterRays[BANDS];
  private final int seed;
  private int pictures;

  /** Uses the random streams {@code camera} and {@code particles}. */
  public WaterRenderer(ColourLens lens, WaterScenery scenery, NoiseStreams streams) {
    this.lens = lens;
    this.scenery = scenery;
    rays = new RayTable(lens);
    light = new float[3 * lens.width() * lens.height()];
    development = new Development(lens, scenery.light, streams.of("camera"));
    seed = streams.of("particles").nextInt();
    Arrays.setAll(baths, band -> development.bath());
    float pixel = 0.5f / (float) lens.intrinsics().focalX();
    Arrays.setAll(tracers, band -> new WaterRays(scenery, pixel));
  }

  /**
   * Renders an image.
   *
   * @return width × height × 3 bytes, RGB, row by row; a new array each time
   */
  public byte[] picture(VehicleTruth truth) {
    RayTable.View view = rays.from(truth);
    for (WaterRays tracer : tracers) {
      tracer.from(view.from, truth.timeS());
    }
    int rows = lens.height();
    IntStream.range(0, BANDS)
        .parallel()
        .forEach(
            band -> {
              int last = (band + 1) * rows / BANDS * lens.width();
              for (int i = band * rows / BANDS * lens.width(); i < last; i++) {
                tracers[band].look(view.way(i), light, 3 * i);
              }
            });
    if (view.from.z() < scenery.look.surfaceM()) {
      particles(tracers[0]);
    }
    pictures++;
    development.begin(light, lens.exposureS() * truth.rates().z());
    byte[] picture = new byte[light.length];
    IntStream.range(0, BANDS)
        .parallel()
        .forEach(
            band ->
                baths[band].develop(
                    light, picture, band * rows / BANDS, (band + 1) * rows / BANDS));
    return picture;
  }

  /** Draws lit particles close to the lens, as blurred discs at new positions in every image. */
  private void particles(WaterRays rays) {
    for (int k = 0; k < scenery.look.particles(); k++) {
      int hash = ValueNoise.mix(seed + pictures * 7919 + k * 104_729);
      int x = (hash & 0xFFFF) * lens.width() >> 16;
      int y = (hash >>> 16) * lens.height() >> 16;
      int more = ValueNoise.mix(hash);
      float radius = 0.6f + 2.4f * (more & 0xFF) / 255.0f * (more >>> 8 & 0xFF) / 255.0f;
      float bright = 0.25f * (more >>> 16 & 0xFF) / 255.0f;
      int reach = (int) Math.ceil(radius);
      for (int row = Math.max(0, y - reach); row <= Math.min(lens.height() - 1, y + reach); row++) {
        for (int col = Math.max(0, x - reach);
            col <= Math.min(lens.width() - 1, x + reach);
            col++) {
          float off = (row - y) * (row - y) + (col - x) * (col - x);
          if (off <= radius * radius) {
            for (int channel = 0; channel < 3; channel++) {
              light[3 * (row * lens.width() + col) + channel] += bright * rays.ambient(channel);
            }
          }
        }
      }
    }
  }
}
