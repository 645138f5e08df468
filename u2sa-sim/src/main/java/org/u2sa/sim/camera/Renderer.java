package org.u2sa.sim.camera;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Renders the view of a vehicle's camera with one ray per pixel and a rolling shutter, then applies
 * lens and sensor effects ({@link Development}). Bands of rows run on all cores with separate
 * buffers, so the image does not depend on their number. Buffers are reused; not thread-safe.
 */
public final class Renderer {
  private static final float TREES = 0.2f; // elevation above which there are no trees
  private static final float GLARE = 2.2f;
  private static final float NEAREST_M = 0.2f; // closer solids may fill the image
  private static final int BANDS = 8;

  private final ColourLens lens;
  private final Scenery scenery;
  private final RayTable rays;
  private final float[] light; // linear red, green, blue per pixel
  private final float[] depth;
  private final CameraPose[] poses; // one per row
  private final CameraPose middle;
  private final RayRow[] rows = new RayRow[BANDS];
  private final int[] boxes; // image bounding box of each solid: left, top, right, bottom
  private final Ground ground;
  private final Development development;
  private final Development.Bath[] baths = new Development.Bath[BANDS];

  /** Uses the random stream {@code camera}. */
  public Renderer(ColourLens lens, Scenery scenery, NoiseStreams streams) {
    this.lens = lens;
    this.scenery = scenery;
    rays = new RayTable(lens);
    light = new float[3 * lens.width() * lens.height()];
    depth = new float[lens.width() * lens.height()];
    poses = new CameraPose[lens.height()];
    Arrays.setAll(poses, row -> new CameraPose(lens));
    Arrays.setAll(rows, band -> new RayRow(lens.width()));
    middle = new CameraPose(lens);
    boxes = new int[4 * scenery.solids.size()];
    ground = new Ground(scenery, (float) lens.intrinsics().focalX());
    development = new Development(lens, scenery.light, streams.of("camera"));
    Arrays.setAll(baths, band -> development.bath());
  }

  /**
   * Renders an image.
   *
   * @return width × height × 3 bytes, RGB, row by row; a new array each time
   */
  public byte[] picture(VehicleTruth truth) {
    middle.at(truth, 0.5 * lens.readoutS());
    for (int i = 0; i < scenery.solids.size(); i++) {
      box(scenery.solids.get(i), truth, 4 * i);
    }
    bands((from, to, band) -> expose(truth, from, to, rows[band]));
    development.begin(light, lens.exposureS() * truth.rates().z());
    byte[] picture = new byte[light.length];
    bands((from, to, band) -> baths[band].develop(light, picture, from, to));
    return picture;
  }

  private interface Band {
    void work(int from, int to, int band);
  }

  private void bands(Band each) {
    int rows = lens.height();
    IntStream.range(0, BANDS)
        .parallel()
        .forEach(band -> each.work(band * rows / BANDS, (band + 1) * rows / BANDS, band));
  }

  private void expose(VehicleTruth truth, int from, int to, RayRow way) {
    for (int row = from; row < to; row++) {
      poses[row].at(truth, lens.readoutS() * row / (lens.height() - 1));
      way.aim(rays, row * lens.width(), poses[row]);
      background(row * lens.width(), poses[row], way);
    }
    Solid.Touch touch = new Solid.Touch();
    for (int k = 0; k < scenery.solids.size(); k++) {
      Solid solid = scenery.solids.get(k);
      int bottom = Math.min(to - 1, boxes[4 * k + 3]);
      for (int row = Math.max(from, boxes[4 * k + 1]); row <= bottom; row++) {
        int last = row * lens.width() + boxes[4 * k + 2];
        for (int i = row * lens.width() + boxes[4 * k]; i <= last; i++) {
          trace(solid, i, poses[row], touch);
        }
      }
    }
  }

  private void background(int at, CameraPose pose, RayRow way) {
    boolean glares = scenery.light.glare() > 0.0;
    for (int i = 0; i < lens.width(); i++) {
      float dx = way.dx[i];
      float dy = way.dy[i];
      float dz = way.dz[i];
      int pixel = at + i;
      if (dz < -1.0e-3f) {
        float t = -pose.z / dz;
        depth[pixel] = t;
        ground.look(pose.x, pose.y, t, dx, dy, -dz, 1.0f, light, 3 * pixel);
      } else {
        depth[pixel] = Float.POSITIVE_INFINITY;
        sky(dx, dy, dz, 3 * pixel);
      }
      if (glares) {
        veil(dx, dy, dz, 3 * pixel);
      }
    }
  }

  private void sky(float dx, float dy, float dz, int to) {
    float up = dz / (float) Math.sqrt(dx * dx + dy * dy);
    if (up < TREES && up < scenery.treesUp(dx, dy)) {
      float bright = (float) (scenery.light.sky() + 0.3 * scenery.light.sun());
      light[to] = 0.03f * bright;
      light[to + 1] = 0.05f * bright;
      light[to + 2] = 0.025f * bright;
      return;
    }
    float high = Math.min(1.0f, up);
    float bright = 0.35f + 0.25f * (float) (scenery.light.sky() + scenery.light.sun());
    boolean clear = scenery.light.sun() > 0.4;
    light[to] = bright * (clear ? 0.85f - 0.5f * high : 0.95f);
    light[to + 1] = bright * (clear ? 0.95f - 0.3f * high : 0.97f);
    light[to + 2] = bright;
  }

  /** Lens flare: increases toward the sun. */
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

  /** Image bounding box of a solid; empty if it is behind the camera. */
  private void box(Solid solid, VehicleTruth truth, int into) {
    float[] column = solid.column();
    float x = column[0] - middle.x;
    float y = column[1] - middle.y;
    float z = column[2] - middle.z;
    float ahead = x * middle.axis[0] + y * middle.axis[1] + z * middle.axis[2];
    float deep = reach(column, middle.axis);
    int top = 0;
    int bottom = ahead < -deep ? -1 : lens.height() - 1;
    int left = 0;
    int right = lens.width() - 1;
    boolean distorted = lens.k1() != 0.0 || lens.k2() != 0.0;
    if (!distorted) {
      float near = ahead - deep;
      float far = ahead + deep;
      float focal = (float) lens.intrinsics().focalX();
      float aside = x * middle.right[0] + y * middle.right[1] + z * middle.right[2];
      float below = x * middle.below[0] + y * middle.below[1] + z * middle.below[2];
      float wide = reach(column, middle.right);
      float tall = reach(column, middle.below);
      float slack = 4.0f + (float) Math.abs(truth.rates().z() * lens.readoutS()) * focal;
      float centreX = (float) lens.intrinsics().centreX();
      float centreY = (float) lens.intrinsics().centreY();
      left = Math.max(0, (int) (centreX + focal * least(aside - wide, near, far) - slack));
      right = Math.min(right, (int) (centreX + focal * -least(-aside - wide, near, far) + slack));
      top = Math.max(0, (int) (centreY + focal * least(below - tall, near, far) - slack));
      bottom = Math.min(bottom, (int) (centreY + focal * -least(-below - tall, near, far) + slack));
    }
    boxes[into] = left;
    boxes[into + 1] = top;
    boxes[into + 2] = right;
    boxes[into + 3] = bottom;
  }

  /** Conservative half-extent of a column along a camera axis [m]. */
  private static float reach(float[] column, float[] axis) {
    float level = (float) Math.sqrt(axis[0] * axis[0] + axis[1] * axis[1]);
    return 1.1f * (column[3] * level + column[4] * Math.abs(axis[2])) + 0.05f;
  }

  /**
   * Minimum image coordinate of a column's side, from its nearest or farthest distance; unlimited
   * if the column reaches the camera.
   */
  private static float least(float side, float near, float far) {
    if (side > 0.0f) {
      return side / far;
    }
    return near > NEAREST_M ? side / near : Float.NEGATIVE_INFINITY;
  }

  private void trace(Solid solid, int i, CameraPose pose, Solid.Touch touch) {
    float u = rays.right[i];
    float v = rays.down[i];
    float dx = u * pose.right[0] + v * pose.below[0] + pose.axis[0];
    float dy = u * pose.right[1] + v * pose.below[1] + pose.axis[1];
    float dz = u * pose.right[2] + v * pose.below[2] + pose.axis[2];
    touch.isGround = false;
    float t = solid.meets(pose.x, pose.y, pose.z, dx, dy, dz, touch);
    if (t < depth[i]) {
      depth[i] = t;
      float[] sun = scenery.sun;
      float facing = Math.max(0.0f, touch.nx * sun[0] + touch.ny * sun[1] + touch.nz * sun[2]);
      if (touch.isGround) {
        float fall = -(touch.nx * dx + touch.ny * dy + touch.nz * dz);
        ground.look(pose.x, pose.y, t, dx, dy, fall, facing / sun[2], light, 3 * i);
      } else {
        float bright =
            (float) (scenery.light.sky() * (0.65 + 0.35 * touch.nz) + scenery.light.sun() * facing);
        light[3 * i] = (touch.colour >> 16 & 0xFF) / 255.0f * bright;
        light[3 * i + 1] = (touch.colour >> 8 & 0xFF) / 255.0f * bright;
        light[3 * i + 2] = (touch.colour & 0xFF) / 255.0f * bright;
      }
      if (scenery.light.glare() > 0.0) {
        veil(dx, dy, dz, 3 * i);
      }
    }
  }
}
