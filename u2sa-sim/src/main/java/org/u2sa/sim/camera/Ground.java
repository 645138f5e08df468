package org.u2sa.sim.camera;

/** Looks up the lawn where a pixel sees it, over all that the pixel covers. For one thread. */
final class Ground {
  private static final int MOST_SAMPLES = 4;
  private static final float FULL = 255.0f;
  private static final float MIDDLE = 128.0f;

  private final Lawn lawn;
  private final float focal;
  private final float perCell;
  private final float perBlade;
  private final float sky;
  private final float sun;
  private final float[] sum = new float[4];
  private final float[] blades = new float[4];

  Ground(Scenery scenery, float focal) {
    lawn = scenery.lawn;
    this.focal = focal;
    perCell = (float) (1.0 / lawn.cellM());
    perBlade = (float) (1.0 / lawn.bladeM());
    sky = (float) scenery.light.sky();
    sun = (float) scenery.light.sun() * scenery.sun[2];
  }

  /**
   * @param t how far along the ray the ground is, in lengths of its direction
   * @param into takes red, green and blue from an index on
   */
  void look(float x, float y, float t, float dx, float dy, float dz, float[] into, int at) {
    float across = t / focal;
    float along = across / Math.max(0.02f, -dz); // a pixel's reach along the ground
    int level = MipMap.level(across * perCell);
    int bladeLevel = MipMap.level(0.5f * (across + along) * perBlade);
    float cells = along * perCell / (1 << level);
    int samples = Math.max(1, Math.min(MOST_SAMPLES, (int) cells));
    float weight = 1.0f / samples;
    float step = t / focal / Math.max(0.02f, -dz) * weight;
    float from = t - 0.5f * (samples - 1) * step;
    sum[0] = 0.0f;
    sum[1] = 0.0f;
    sum[2] = 0.0f;
    sum[3] = 0.0f;
    for (int k = 0; k < samples; k++) {
      float east = x + (from + k * step) * dx - (float) lawn.westM();
      float north = y + (from + k * step) * dy - (float) lawn.southM();
      lawn.map().add(level, east * perCell, north * perCell, weight, sum);
    }
    blades[0] = 0.0f;
    lawn.blades().add(bladeLevel, (x + t * dx) * perBlade, (y + t * dy) * perBlade, 1.0f, blades);
    float bright = (sky + sun * sum[3] / FULL) * blades[0] / MIDDLE / FULL;
    into[at] = bright * sum[2];
    into[at + 1] = bright * sum[1];
    into[at + 2] = bright * sum[0];
  }
}
