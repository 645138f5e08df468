package org.u2sa.sim.camera;

/** Samples the lawn over a pixel's footprint. Immutable. */
final class Ground {
  private static final float FULL = 255.0f * 256.0f; // full scale of a channel
  private static final float MIDDLE = 128.0f * 256.0f;
  private static final float STEEPEST = 0.02f; // ray descent below which the pixel sees the horizon
  private static final long CHANNEL = 0xFFFFL;
  private static final long HALVES = 0x7FFF_7FFF_7FFF_7FFFL;
  private static final long QUARTERS = 0x3FFF_3FFF_3FFF_3FFFL;

  private final MipMap map;
  private final TiledMap blades;
  private final float west;
  private final float south;
  private final float perFocal;
  private final float perCell;
  private final float perBlade;
  private final float sky;
  private final float sun;

  Ground(Scenery scenery, float focal) {
    Lawn lawn = scenery.lawn;
    map = lawn.map();
    blades = lawn.blades();
    west = (float) lawn.westM();
    south = (float) lawn.southM();
    perFocal = 1.0f / focal;
    perCell = (float) (1.0 / lawn.cellM());
    perBlade = (float) (1.0 / lawn.bladeM());
    sky = (float) scenery.light.sky();
    sun = (float) scenery.light.sun() * scenery.sun[2];
  }

  /**
   * @param t distance to the ground along the ray, in lengths of its direction
   * @param fall approach to the (possibly sloped) ground per length of the direction
   * @param facing sunlight received, relative to level ground
   * @param into receives red, green and blue, starting at an index
   */
  void look(
      float x,
      float y,
      float t,
      float dx,
      float dy,
      float fall,
      float facing,
      float[] into,
      int at) {
    float across = t * perFocal;
    float along =
        across / Math.max(STEEPEST, fall); // length of the pixel footprint along the ground
    int level = MipMap.level(across * perCell);
    int bladeLevel = MipMap.level(0.5f * (across + along) * perBlade);
    float east = x + t * dx;
    float north = y + t * dy;
    float column = (east - west) * perCell;
    float row = (north - south) * perCell;
    long seen = seen(level, column, row, along * dx * perCell, along * dy * perCell, along);
    float grass = blades.at(bladeLevel, east * perBlade, north * perBlade);
    float lit = sky + sun * facing * (int) (seen >>> 48) / FULL;
    float bright = lit * grass / (MIDDLE * FULL);
    into[at] = bright * (int) (seen >>> 16 & CHANNEL);
    into[at + 1] = bright * (int) (seen >>> 32 & CHANNEL);
    into[at + 2] = bright * (int) (seen & CHANNEL);
  }

  /** Averages one, two or four samples, one cell of the level apart. */
  private long seen(int level, float column, float row, float dx, float dy, float along) {
    float cells = along * perCell * MipMap.scale(level);
    if (cells < 2.0f) {
      return map.at(level, column, row);
    }
    if (cells < 4.0f) {
      long one = map.at(level, column - 0.25f * dx, row - 0.25f * dy);
      long other = map.at(level, column + 0.25f * dx, row + 0.25f * dy);
      return (one >>> 1 & HALVES) + (other >>> 1 & HALVES);
    }
    long sum = 0L;
    for (int k = 0; k < 4; k++) {
      float share = (k - 1.5f) / 4.0f;
      sum += map.at(level, column + share * dx, row + share * dy) >>> 2 & QUARTERS;
    }
    return sum;
  }
}
