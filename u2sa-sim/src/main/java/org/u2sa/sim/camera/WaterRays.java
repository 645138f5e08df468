package org.u2sa.sim.camera;

import org.u2sa.messages.frame.Point;

/**
 * Radiance along rays in air and water: Fresnel reflection and sun glitter on the waves (Cox and
 * Munk 1954), refraction, beam attenuation and backscatter under water (Akkaynak and Treibitz, A
 * revised underwater image formation model, CVPR 2018), caustics. One thread only.
 */
final class WaterRays {
  private static final float INDEX = 1.34f; // refractive index of water
  private static final float GRAZING = 0.02f; // reflectance at vertical incidence
  private static final float REACH = 80.0f; // distance up to which reflections show objects [m]
  private static final float BRIGHTEST = 30.0f;
  private static final float SUN_COSINE = 0.99995f;
  private static final float CAUSTIC_CELL = 0.45f; // [m]
  private static final int SAND = Reflectance.rgb(0.42, 0.38, 0.30);

  private final WaterScenery scenery;
  private final Solid.Touch touch = new Solid.Touch();
  private final float[] slope = new float[3];
  private final float[][] bounds; // centre and squared radius of each solid
  private final float[] found = new float[3]; // colour of the last hit
  private final float pixel;
  private final float surface;
  private float ox; // of the camera
  private float oy;
  private float oz;
  private double timeS;

  WaterRays(WaterScenery scenery, float pixel) {
    this.scenery = scenery;
    this.pixel = pixel;
    touch.pixel = pixel;
    surface = (float) scenery.look.surfaceM();
    bounds = new float[scenery.solids.size()][];
    for (int i = 0; i < bounds.length; i++) {
      float[] c = scenery.solids.get(i).column();
      float radius = (float) Math.hypot(c[3], c[4]) + 0.05f;
      bounds[i] = new float[] {c[0], c[1], c[2], radius * radius};
    }
  }

  void from(Point camera, double newTimeS) {
    ox = (float) camera.x();
    oy = (float) camera.y();
    oz = (float) camera.z();
    timeS = newTimeS;
  }

  /** Light under water at the camera's depth. */
  float ambient(int channel) {
    return daylight(channel, surface - oz);
  }

  private float daylight(int channel, float depth) {
    return scenery.daylight()
        * (float) Math.exp(-scenery.look.type().diffuse(channel) * Math.max(0.0f, depth));
  }

  /** Radiance along a unit vector from the camera. */
  void look(Point way, float[] into, int at) {
    float dx = (float) way.x();
    float dy = (float) way.y();
    float dz = (float) way.z();
    if (oz >= surface) {
      air(dx, dy, dz, into, at);
    } else {
      water(ox, oy, oz, dx, dy, dz, 0.0f, into, at);
    }
  }

  private void air(float dx, float dy, float dz, float[] into, int at) {
    float toWater = dz < 0.0f ? (surface - oz) / dz : Float.POSITIVE_INFINITY;
    float hit = nearest(ox, oy, oz, dx, dy, dz, toWater);
    float cover = hit < toWater ? touch.cover : 0.0f;
    if (cover > 0.0f) {
      lit(found);
    }
    float red = found[0];
    float green = found[1];
    float blue = found[2];
    if (cover < 1.0f) {
      if (toWater < 1.0e5f) {
        surface(dx, dy, dz, toWater, into, at);
      } else {
        sky(dx, dy, dz, into, at);
      }
    }
    into[at] += cover * (red - into[at]);
    into[at + 1] += cover * (green - into[at + 1]);
    into[at + 2] += cover * (blue - into[at + 2]);
  }

  /** Radiance of the surface seen from above. */
  private void surface(float dx, float dy, float dz, float t, float[] into, int at) {
    float x = ox + t * dx;
    float y = oy + t * dy;
    scenery.waves.at(x, y, timeS, pixel * t / Math.max(0.02f, (float) Math.sqrt(-dz)), slope);
    float sx = slope[0];
    float sy = slope[1];
    float variance = slope[2];
    float norm = 1.0f / (float) Math.sqrt(1.0f + sx * sx + sy * sy);
    float facing = Math.max(0.02f, (dx * sx + dy * sy - dz) * norm);
    // facets that face away are hidden: rough water looks steeper towards the horizon
    float effective = Math.min(1.0f, facing + 0.8f * (float) Math.sqrt(variance));
    float reflected = fresnel(effective);
    float rx = dx - 2.0f * facing * sx * norm;
    float ry = dy - 2.0f * facing * sy * norm;
    float rz = Math.abs(dz + 2.0f * effective * norm) + 0.01f;
    float length = 1.0f / (float) Math.sqrt(rx * rx + ry * ry + rz * rz);
    float hit =
        t < REACH
            ? nearest(x, y, surface, rx * length, ry * length, rz * length, REACH)
            : Float.POSITIVE_INFINITY;
    if (hit < REACH) {
      lit(found);
      into[at] = found[0];
      into[at + 1] = found[1];
      into[at + 2] = found[2];
    } else {
      sky(rx * length, ry * length, rz * length, into, at);
    }
    float glitter = glitter(dx, dy, dz, sx, sy, variance + 2.0e-4f, facing);
    float day = scenery.daylight();
    boolean shallow = t < REACH && through(x, y, dx, dy, dz, sx, sy);
    for (int channel = 0; channel < 3; channel++) {
      float below = shallow ? found[channel] : day * scenery.look.upwelling(channel);
      into[at + channel] =
          reflected * Math.min(1.5f, into[at + channel])
              + (1.0f - reflected) * below
              + glitter * (channel == 2 ? 0.9f : 1.0f);
    }
  }

  /** Stores the object seen through the surface in {@link #found}; false if there is only water. */
  private boolean through(float x, float y, float dx, float dy, float dz, float sx, float sy) {
    float rx = dx / INDEX - 0.25f * sx;
    float ry = dy / INDEX - 0.25f * sy;
    float flat = Math.min(0.98f, rx * rx + ry * ry);
    water(x, y, surface - 0.001f, rx, ry, -(float) Math.sqrt(1.0f - flat), 1.0f, found, 0);
    return true;
  }

  private float glitter(
      float dx, float dy, float dz, float sx, float sy, float variance, float facing) {
    if (scenery.light.sun() == 0.0) {
      return 0.0f;
    }
    float[] sun = scenery.sun;
    float hx = sun[0] - dx;
    float hy = sun[1] - dy;
    float hz = sun[2] - dz;
    float length = (float) Math.sqrt(hx * hx + hy * hy + hz * hz);
    float offEast = -hx / hz - sx;
    float offNorth = -hy / hz - sy;
    float square = (offEast * offEast + offNorth * offNorth) / (2.0f * variance);
    if (square > 12.0f) {
      return 0.0f;
    }
    float upright = hz / length;
    float density = (float) (Math.exp(-square) / (2.0 * Math.PI * variance));
    float cosine = (sun[0] * hx + sun[1] * hy + sun[2] * hz) / length;
    // L = E F p / (4 cos θ cos⁴ β) (Cox and Munk 1954, eq. 9), with E = π sun
    float glint =
        (float) (Math.PI * scenery.light.sun())
            * fresnel(cosine)
            * density
            / (4.0f * Math.max(0.15f, facing) * upright * upright * upright * upright);
    return Math.min(BRIGHTEST, glint);
  }

  private static float fresnel(float cosine) {
    float left = 1.0f - Math.min(1.0f, Math.max(0.0f, cosine)); // Schlick 1994
    return GRAZING + (1.0f - GRAZING) * left * left * left * left * left;
  }

  private void sky(float dx, float dy, float dz, float[] into, int at) {
    float up = Math.max(0.0f, dz);
    float bright = 0.35f + 0.25f * (float) (scenery.light.sky() + scenery.light.sun());
    boolean clear = scenery.light.sun() > 0.4;
    float[] sun = scenery.sun;
    float cosine = dx * sun[0] + dy * sun[1] + dz * sun[2];
    float glow = (float) scenery.light.sun() * Math.max(0.0f, cosine - 0.6f);
    float disc = clear && cosine > SUN_COSINE ? BRIGHTEST : 0.0f;
    into[at] = bright * (clear ? 0.85f - 0.55f * up : 0.95f) + glow + disc;
    into[at + 1] = bright * (clear ? 0.95f - 0.35f * up : 0.97f) + glow + disc;
    into[at + 2] = bright + glow + disc;
  }

  /** Reflectance of the last hit in daylight. */
  private void lit(float[] into) {
    float[] sun = scenery.sun;
    float facing = Math.max(0.0f, touch.nx * sun[0] + touch.ny * sun[1] + touch.nz * sun[2]);
    float bright =
        (float) (scenery.light.sky() * (0.65 + 0.35 * touch.nz) + scenery.light.sun() * facing);
    for (int channel = 0; channel < 3; channel++) {
      into[channel] = (touch.colour >> 16 - 8 * channel & 0xFF) / 255.0f * bright;
    }
  }

  /**
   * Radiance under water.
   *
   * @param loss 1 for rays that entered from the air, whose upward path is not attenuated by the
   *     camera's own depth
   */
  private void water(
      float x, float y, float z, float dx, float dy, float dz, float loss, float[] into, int at) {
    float floor = surface - (float) scenery.look.depthM();
    float end = Float.POSITIVE_INFINITY;
    if (dz > 0.0f) {
      end = (surface - z) / dz;
    } else if (dz < 0.0f) {
      end = (floor - z) / dz;
    }
    float hit = nearest(x, y, z, dx, dy, dz, end);
    float cover = hit < end ? touch.cover : 0.0f;
    int colour = touch.colour;
    float nz = touch.nz;
    float bx = x + Math.min(end, 1.0e4f) * dx;
    float by = y + Math.min(end, 1.0e4f) * dy;
    float deep = surface - (z + hit * dz);
    float spot = cover > 0.0f && nz > 0.1f ? caustic(x + hit * dx, y + hit * dy, deep) : 1.0f;
    float fade = 0.55f + 0.45f * nz;
    boolean isFloor = dz < 0.0f;
    float sand = isFloor && end < 60.0f ? floor(bx, by) : 1.0f;
    float window = dz > 0.0f && end < 60.0f ? window(bx, by, dx, dy, dz) : 0.0f;
    for (int channel = 0; channel < 3; channel++) {
      float beam = scenery.look.beam(channel);
      float middle = z + dz * 0.5f * Math.min(Math.min(hit, end), 1.0f / beam);
      float veil = scenery.look.veil(channel) * daylight(channel, surface - middle);
      float behind = veil;
      if (end < 1.0e4f) {
        float seen;
        if (isFloor) {
          float reflectance = (SAND >> 16 - 8 * channel & 0xFF) / 255.0f;
          seen = sand * reflectance * daylight(channel, surface - floor);
        } else {
          seen = window * 0.9f * scenery.daylight() + (1.0f - window) * veil;
        }
        float left = (float) Math.exp(-beam * end);
        behind = seen * left + veil * (1.0f - left);
      }
      if (cover > 0.0f) {
        float reflectance = (colour >> 16 - 8 * channel & 0xFF) / 255.0f;
        float left = (float) Math.exp(-beam * hit);
        float shown = reflectance * spot * fade * daylight(channel, deep);
        behind += cover * (shown * left + veil * (1.0f - left) - behind);
      }
      into[at + channel] = loss > 0.0f ? 0.54f * behind : behind; // n² law: 0.97 / 1.34²
    }
  }

  /** Light on the floor: its texture and caustics. */
  private float floor(float x, float y) {
    float grain = 1.0f + 0.12f * (float) scenery.noise.fractal(1.7 * x, 1.7 * y, 3);
    return grain * caustic(x, y, (float) scenery.look.depthM());
  }

  /** Focused sunlight under waves, 1 on average. */
  private float caustic(float x, float y, float depth) {
    if (scenery.light.sun() == 0.0) {
      return 1.0f;
    }
    double drift = 0.5 * timeS;
    double a = scenery.noise.at(x / CAUSTIC_CELL + drift, y / CAUSTIC_CELL - 0.3 * drift);
    double b = scenery.noise.at(1.7 * y / CAUSTIC_CELL - drift, 1.7 * x / CAUSTIC_CELL + 40.0);
    double ridge = 1.0 - Math.abs(0.6 * a + 0.4 * b);
    double square = ridge * ridge;
    double focus = square * square * square - 0.42;
    return (float) Math.max(0.4, 1.0 + 0.9 * Math.exp(-depth / 8.0) * focus);
  }

  /** Snell's window: 1 where the sky is seen through the surface, 0 where it reflects totally. */
  private float window(float x, float y, float dx, float dy, float dz) {
    scenery.waves.at(x, y, timeS, 0.05f, slope);
    float cosine = dz - 0.5f * (dx * slope[0] + dy * slope[1]);
    float sine = INDEX * INDEX * (1.0f - cosine * cosine);
    return sine >= 1.0f ? 0.0f : 1.0f - fresnel((float) Math.sqrt(1.0f - sine));
  }

  /** Distance to the nearest solid; stores the hit in {@link #touch}. */
  private float nearest(float x, float y, float z, float dx, float dy, float dz, float farthest) {
    float best = farthest;
    int colour = 0;
    float nx = 0.0f;
    float ny = 0.0f;
    float nz = 0.0f;
    float cover = 1.0f;
    for (int i = 0; i < bounds.length; i++) {
      float[] ball = bounds[i];
      float cx = ball[0] - x;
      float cy = ball[1] - y;
      float cz = ball[2] - z;
      float along = cx * dx + cy * dy + cz * dz;
      float square = cx * cx + cy * cy + cz * cz;
      float wide = pixel * Math.max(0.0f, along);
      if (square - along * along > ball[3] + wide * wide + 2.0f * wide
          || along < 0.0f && square > ball[3]) {
        continue;
      }
      touch.cover = 1.0f;
      float hit = scenery.solids.get(i).meets(x, y, z, dx, dy, dz, touch);
      if (hit < best) {
        best = hit;
        colour = touch.colour;
        nx = touch.nx;
        ny = touch.ny;
        nz = touch.nz;
        cover = touch.cover;
      }
    }
    touch.colour = colour;
    touch.nx = nx;
    touch.ny = ny;
    touch.nz = nz;
    touch.cover = cover;
    return best;
  }
}
