package org.u2sa.sim.camera;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.HotTarget;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Renders the image of a long-wave infrared camera above water: grey values are apparent
 * temperatures between two limits. Water reflects the cold sky at grazing angles, objects have the
 * air's temperature, and hot targets exceed it by their own value. Not thread-safe.
 */
public final class ThermalRenderer {
  private static final double AIR_C = 22.0;
  private static final double WATER_C = 18.0;
  private static final double ZENITH_C = -25.0; // apparent temperature of a clear sky
  private static final double HORIZON_C = 12.0;
  private static final double ZERO_K = 273.15;
  private static final double FULL = 255.0;

  private final ColourLens lens;
  private final RayTable rays;
  private final double surfaceM;
  private final double coldestK;
  private final double hottestK;
  private final Random noise;
  private final List<Solid> solids = new ArrayList<>();
  private final List<Double> temperatures = new ArrayList<>();
  private final Solid.Touch touch = new Solid.Touch();

  /**
   * Uses the random stream {@code thermal}.
   *
   * @param lens its sigma is the noise-equivalent temperature difference, relative to the range
   * @param objects in LOCAL_ENU
   * @param surfaceM height of the water's surface [m]
   * @param coldestK temperature shown as 0 [K]
   * @param hottestK temperature shown as 255 [K]
   */
  public ThermalRenderer(
      ColourLens lens,
      List<? extends ObjectDescription> objects,
      double surfaceM,
      double coldestK,
      double hottestK,
      NoiseStreams streams) {
    this.lens = lens;
    this.surfaceM = surfaceM;
    this.coldestK = coldestK;
    this.hottestK = hottestK;
    rays = new RayTable(lens);
    noise = streams.of("thermal");
    touch.pixel = 0.5f / (float) lens.intrinsics().focalX();
    for (ObjectDescription object : objects) {
      double excess = object instanceof HotTarget hot ? hot.excessTemperature().orElse(0.0) : 0.0;
      for (Solid solid : MarineShapes.of(object)) {
        solids.add(solid);
        temperatures.add(AIR_C + excess);
      }
    }
  }

  /**
   * Renders an image.
   *
   * @return width × height bytes, row by row; a new array each time
   */
  public byte[] picture(VehicleTruth truth) {
    RayTable.View view = rays.from(truth);
    byte[] picture = new byte[lens.width() * lens.height()];
    for (int i = 0; i < picture.length; i++) {
      double share = (ZERO_K + celsius(view.from, view.way(i)) - coldestK) / (hottestK - coldestK);
      double noisy = share + lens.sigma() * noise.nextGaussian();
      picture[i] = (byte) Math.round(FULL * Math.max(0.0, Math.min(1.0, noisy)));
    }
    return picture;
  }

  private double celsius(Point from, Point way) {
    double nearest =
        way.z() < 0.0 ? Math.max(0.0, (surfaceM - from.z()) / way.z()) : Double.POSITIVE_INFINITY;
    double up = Math.abs(way.z());
    double sky = HORIZON_C + (ZENITH_C - HORIZON_C) * Math.sqrt(up);
    double reflected = Math.pow(1.0 - up, 5.0);
    double found = way.z() < 0.0 ? WATER_C + reflected * (sky - WATER_C) : sky;
    for (int i = 0; i < solids.size(); i++) {
      float hit =
          solids
              .get(i)
              .meets(
                  (float) from.x(),
                  (float) from.y(),
                  (float) from.z(),
                  (float) way.x(),
                  (float) way.y(),
                  (float) way.z(),
                  touch);
      if (hit < nearest) {
        nearest = hit;
        found = temperatures.get(i);
      }
    }
    return found;
  }
}
