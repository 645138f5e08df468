package org.u2sa.sim.camera;

/** A picture of the ground in four channels of 8 bits, and the same at halved sizes. Immutable. */
final class MipMap {
  private static final int LEVELS = 6;

  private final int[][] pixels = new int[LEVELS][];
  private final int[] widths = new int[LEVELS];
  private final int[] heights = new int[LEVELS];
  private final boolean tiled;

  /**
   * @param tiled whether it repeats, with sides that are powers of two; otherwise its rim goes on
   */
  MipMap(int[] finest, int width, int height, boolean tiled) {
    this.tiled = tiled;
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

  /** The level whose cells are so many of the finest ones wide. */
  static int level(float cells) {
    int level = cells <= 1.0f ? 0 : Math.getExponent(cells);
    return Math.min(LEVELS - 1, level);
  }

  /**
   * Adds what is at a place, between the four nearest cells.
   *
   * @param x in cells of the finest level, from the middle of the first
   * @param sum its four channels, lowest bits first, each 0…255 times the weight
   */
  void add(int level, float x, float y, float weight, float[] sum) {
    int width = widths[level];
    int height = heights[level];
    float scale = 1.0f / (1 << level);
    float u = (x + 0.5f) * scale - 0.5f;
    float v = (y + 0.5f) * scale - 0.5f;
    int column = floor(u);
    int row = floor(v);
    float right = u - column;
    float down = v - row;
    int x0;
    int x1;
    int y0;
    int y1;
    if (tiled) {
      x0 = column & width - 1;
      x1 = column + 1 & width - 1;
      y0 = row & height - 1;
      y1 = row + 1 & height - 1;
    } else {
      x0 = Math.max(0, Math.min(width - 1, column));
      x1 = Math.max(0, Math.min(width - 1, column + 1));
      y0 = Math.max(0, Math.min(height - 1, row));
      y1 = Math.max(0, Math.min(height - 1, row + 1));
    }
    int[] cells = pixels[level];
    int a = cells[y0 * width + x0];
    int b = cells[y0 * width + x1];
    int c = cells[y1 * width + x0];
    int d = cells[y1 * width + x1];
    float wb = right * (1.0f - down) * weight;
    float wc = (1.0f - right) * down * weight;
    float wd = right * down * weight;
    float wa = weight - wb - wc - wd;
    sum[0] += wa * (a & 0xFF) + wb * (b & 0xFF) + wc * (c & 0xFF) + wd * (d & 0xFF);
    sum[1] +=
        wa * (a >> 8 & 0xFF) + wb * (b >> 8 & 0xFF) + wc * (c >> 8 & 0xFF) + wd * (d >> 8 & 0xFF);
    sum[2] +=
        wa * (a >> 16 & 0xFF)
            + wb * (b >> 16 & 0xFF)
            + wc * (c >> 16 & 0xFF)
            + wd * (d >> 16 & 0xFF);
    sum[3] += wa * (a >>> 24) + wb * (b >>> 24) + wc * (c >>> 24) + wd * (d >>> 24);
  }

  private static int floor(float value) {
    int whole = (int) value;
    return value < whole ? whole - 1 : whole;
  }
}
