package org.u2sa.sim.camera;

/**
 * Mip map of a ground texture with four 8-bit channels; beyond its edge it continues. Immutable.
 */
final class MipMap {
  static final int LEVELS = 6;
  static final int ONE = 256; // weight of a cell sampled at its centre

  private static final float[] SCALES = {1.0f, 0.5f, 0.25f, 0.125f, 0.0625f, 0.03125f};

  private final int[][] pixels = new int[LEVELS][];
  private final int[] widths = new int[LEVELS];
  private final int[] heights = new int[LEVELS];

  MipMap(int[] finest, int width, int height) {
    pixels[0] = finest;
    widths[0] = width;
    heights[0] = height;
    for (int level = 1; level < LEVELS; level++) {
      halve(level);
    }
  }

  private void halve(int level) {
    int[] from = pixels[level - 1];
    int width = Math.max(1, widths[level - 1] / 2);
    int height = Math.max(1, heights[level - 1] / 2);
    int[] to = new int[width * height];
    int stride = widths[level - 1];
    int lastX = stride - 1;
    int lastY = heights[level - 1] - 1;
    for (int y = 0; y < height; y++) {
      int above = Math.min(lastY, 2 * y) * stride;
      int below = Math.min(lastY, 2 * y + 1) * stride;
      for (int x = 0; x < width; x++) {
        int left = Math.min(lastX, 2 * x);
        int right = Math.min(lastX, 2 * x + 1);
        to[y * width + x] =
            mean(from[above + left], from[above + right], from[below + left], from[below + right]);
      }
    }
    pixels[level] = to;
    widths[level] = width;
    heights[level] = height;
  }

  private static int mean(int a, int b, int c, int d) {
    int mean = 0;
    for (int shift = 0; shift < 32; shift += 8) {
      int sum = (a >>> shift & 0xFF) + (b >>> shift & 0xFF) + (c >>> shift & 0xFF);
      mean |= (sum + (d >>> shift & 0xFF) + 2) / 4 << shift;
    }
    return mean;
  }

  /** Level whose cells span this many finest cells. */
  static int level(float cells) {
    int level = cells <= 1.0f ? 0 : Math.getExponent(cells);
    return Math.min(LEVELS - 1, level);
  }

  /** Cells of a level per finest cell. */
  static float scale(int level) {
    return SCALES[level];
  }

  /**
   * Bilinear sample: four 16-bit channels, each 0…255 times 256. From the lowest bits up: bits 0–7,
   * 16–23, 8–15 and 24–31 of a cell.
   *
   * @param x in cells of the finest level, from the centre of the first
   */
  long at(int level, float x, float y) {
    float scale = SCALES[level];
    float u = (x + 0.5f) * scale - 0.5f;
    float v = (y + 0.5f) * scale - 0.5f;
    int column = floor(u);
    int row = floor(v);
    int right = (int) ((u - column) * ONE);
    int down = (int) ((v - row) * ONE);
    int width = widths[level];
    int height = heights[level];
    int x0 = inside(column, width);
    int x1 = inside(column + 1, width);
    int above = inside(row, height) * width;
    int below = inside(row + 1, height) * width;
    int[] cells = pixels[level];
    int both = right * down >> 8;
    return (ONE - right - down + both) * spread(cells[above + x0])
        + (right - both) * spread(cells[above + x1])
        + (down - both) * spread(cells[below + x0])
        + both * spread(cells[below + x1]);
  }

  private static int inside(int column, int width) {
    return Math.max(0, Math.min(width - 1, column));
  }

  private static long spread(int cell) {
    return cell & 0xFF00FFL | (cell >>> 8 & 0xFF00FFL) << 32;
  }

  static int floor(float value) {
    int whole = (int) value;
    return value < whole ? whole - 1 : whole;
  }
}
