package org.u2sa.sim.camera;

import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Renders what a camera on a vehicle sees, a ray a pixel, each row at its own moment; then lens and
 * sensor do their harm ({@link Development}). Buffers are reused; for one thread.
 */
public final class Renderer {
  private static final float TREES = 0.2f; // higher above the horizon there are none
  private static final float GLARE = 2.2f;

  private final ColourLens lens;
  private final Scenery scenery;
  private final CameraPose pose;
  private final RayTable rays;
  private final float[] light; // red, green, blue of each pixel, linear
  private final float[] depth;
  private final Ground ground;
  private final Development development;
  private final Solid.Touch touch = new Solid.Touch();

  /** Takes the stream {@code camera}. */
  public Renderer(ColourLens lens, Scenery scenery, NoiseStreams streams) {
    this.lens = lens;
    this.scenery = scenery;
    pose = new CameraPose(lens);
    rays = new RayTable(lens);
    light = new float[3 * lens.width() * lens.height()];
    depth = new float[lens.width() * lens.height()];
    ground = new Ground(scenery, (float) lens.intrinsics().focalX());
    development = new Development(lens, scenery.light, streams.of("camera"));
  }

  /**
   * Takes a picture.
   *
   * @return width × height × 3 bytes, red, green and blue, row by row; new for each picture
   */
  public byte[] picture(VehicleTruth truth) {
    for (int row = 0; row < lens.height(); row++) {
      pose.at(truth, pose.rowS(row));
      background(row);
    }
    for (Solid solid : scenery.solids) {
      draw(solid, truth);
    }
    return development.develop(light, lens.exposureS() * truth.rates().z());
  }

  private void background(int row) {
    int at = row * lens.width();
    for (int i = at; i < at + lens.width(); i++) {
      float u = rays.right[i];
      float v = rays.down[i];
      float dx = u * pose.right[0] + v * pose.below[0] + pose.axis[0];
      float dy = u * pose.right[1] + v * pose.below[1] + pose.axis[1];
      float dz = u * pose.right[2] + v * pose.below[2] + pose.axis[2];
      if (dz < -1.0e-3f) {
        float t = -pose.z / dz;
        depth[i] = t;
        ground.look(pose.x, pose.y, t, dx, dy, dz, light, 3 * i);
      } else {
        depth[i] = Float.POSITIVE_INFINITY;
        sky(dx, dy, dz, 3 * i);
      }
      if (scenery.light.glare() > 0.0) {
        veil(dx, dy, dz, 3 * i);
      }
    }
  }

  private void sky(float dx, float dy, float dz, int to) {
    float up = dz / (float) Math.sqrt(dx * dx + dy * dy);
    if (up < TREES) {
      double azimuth = Math.atan2(dx, dy) + Math.PI;
      int place = (int) (azimuth / (2.0 * Math.PI) * scenery.skyline.length);
      if (up < scenery.skyline[Math.min(scenery.skyline.length - 1, place)]) {
        float bright = (float) (scenery.light.sky() + 0.3 * scenery.light.sun());
        light[to] = 0.03f * bright;
        light[to + 1] = 0.05f * bright;
        light[to + 2] = 0.025f * bright;
        return;
      }
    }
    float high = Math.min(1.0f, up);
    float bright = 0.35f + 0.25f * (float) (scenery.light.sky() + scenery.light.sun());
    boolean clear = scenery.light.sun() > 0.4;
    light[to] = bright * (clear ? 0.85f - 0.5f * high : 0.95f);
    light[to + 1] = bright * (clear ? 0.95f - 0.3f * high : 0.97f);
    light[to + 2] = bright;
  }

  /** Light that scatters in the lens: more, the nearer the sun. */
  private void veil(float dx, float dy, float dz, int to) {
    float[] sun = scenery.sun;
    float dot = dx * sun[0] + dy * sun[1] + dz * sun[2];
    if (dot > 0.0f) {
      float square = dot * dot / (dx * dx + dy * dy + dz * dz);
      float fourth = square * square;
      float scattered =
          (float) (scenery.light.glare() * scenery.light.sun())
              * (0.05f * square + GLARE * fourth * fourth * fourth);
      light[to] += scattered;
      light[to + 1] += scattered;
      light[to + 2] += 0.9f * scattered;
    }
  }

  private void draw(Solid solid, VehicleTruth truth) {
    float[] ball = solid.ball();
    pose.at(truth, 0.5 * lens.readoutS());
    float x = ball[0] - pose.x;
    float y = ball[1] - pose.y;
    float z = ball[2] - pose.z;
    float ahead = x * pose.axis[0] + y * pose.axis[1] + z * pose.axis[2];
    float radius = 1.1f * ball[3] + 0.02f;
    if (ahead < -radius) {
      return;
    }
    int top = 0;
    int bottom = lens.height() - 1;
    int left = 0;
    int right = lens.width() - 1;
    boolean distorted = lens.k1() != 0.0 || lens.k2() != 0.0;
    float near = ahead - radius;
    if (near > 0.2f && !distorted) {
      float focal = (float) lens.intrinsics().focalX();
      float aside = x * pose.right[0] + y * pose.right[1] + z * pose.right[2];
      float below = x * pose.below[0] + y * pose.below[1] + z * pose.below[2];
      float slack = 4.0f + (float) Math.abs(truth.rates().z() * lens.readoutS()) * focal;
      float centreX = (float) lens.intrinsics().centreX();
      float centreY = (float) lens.intrinsics().centreY();
      left = Math.max(0, (int) (centreX + focal * least(aside - radius, near, ahead) - slack));
      right =
          Math.min(right, (int) (centreX + focal * -least(-aside - radius, near, ahead) + slack));
      top = Math.max(0, (int) (centreY + focal * least(below - radius, near, ahead) - slack));
      bottom =
          Math.min(bottom, (int) (centreY + focal * -least(-below - radius, near, ahead) + slack));
    }
    for (int row = top; row <= bottom; row++) {
      pose.at(truth, pose.rowS(row));
      for (int i = row * lens.width() + left; i <= row * lens.width() + right; i++) {
        trace(solid, i);
      }
    }
  }

  /** The least that a side of a ball may be seen at, by its nearest or middle distance. */
  private static float least(float side, float near, float ahead) {
    return Math.min(side / near, side / (2.0f * ahead - near));
  }

  private void trace(Solid solid, int i) {
    float u = rays.right[i];
    float v = rays.down[i];
    float dx = u * pose.right[0] + v * pose.below[0] + pose.axis[0];
    float dy = u * pose.right[1] + v * pose.below[1] + pose.axis[1];
    float dz = u * pose.right[2] + v * pose.below[2] + pose.axis[2];
    float t = solid.meets(pose.x, pose.y, pose.z, dx, dy, dz, touch);
    if (t < depth[i]) {
      depth[i] = t;
      float[] sun = scenery.sun;
      float facing = Math.max(0.0f, touch.nx * sun[0] + touch.ny * sun[1] + touch.nz * sun[2]);
      float bright =
          (float) (scenery.light.sky() * (0.65 + 0.35 * touch.nz) + scenery.light.sun() * facing);
      light[3 * i] = (touch.colour >> 16 & 0xFF) / 255.0f * bright;
      light[3 * i + 1] = (touch.colour >> 8 & 0xFF) / 255.0f * bright;
      light[3 * i + 2] = (touch.colour & 0xFF) / 255.0f * bright;
      if (scenery.light.glare() > 0.0) {
        veil(dx, dy, dz, 3 * i);
      }
    }
  }
}
