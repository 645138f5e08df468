package org.u2sa.sim.camera;

/** Mip map of a square grey texture that tiles. Immutable. */
final class TiledMap {
  private final byte[][] levels = new byte[MipMap.LEVELS][];
  private final int side;

  /**
   * @param finest brightness of each cell, unsigned, row-major
   * @param side cells of a row, a power of two
   */
  TiledMap(byte[] finest, int side) {
    this.side = side;
    levels[0] = finest;
    for (int level = 1; level < levels.length; level++) {
      levels[level] = halved(levels[level - 1], side >> level);
    }
  }

  private static byte[] halved(byte[] from, int side) {
    byte[] to = new byte[side * side];
    for (int i = 0; i < to.length; i++) {
      int at = 4 * side * (i / side) + 2 * (i % side);
      int sum = (from[at] & 0xFF) + (from[at + 1] & 0xFF);
      sum += (from[at + 2 * side] & 0xFF) + (from[at + 2 * side + 1] & 0xFF);
      to[i] = (byte) ((sum + 2) / 4);
    }
    return to;
  }

  /**
   * Bilinear sample: 0…255 times 256.
   *
   * @param x in cells of the finest level, from the centre of the first
   */
  int at(int level, float x, float y) {
    float scale = MipMap.scale(level);
    float u = (x + 0.5f) * scale - 0.5f;
    float v = (y + 0.5f) * scale - 0.5f;
    int column = MipMap.floor(u);
    int row = MipMap.floor(v);
    int right = (int) ((u - column) * MipMap.ONE);
    int down = (int) ((v - row) * MipMap.ONE);
    int width = side >> level;
    int x0 = column & width - 1;
    int x1 = column + 1 & width - 1;
    int above = (row & width - 1) * width;
    int below = (row + 1 & width - 1) * width;
    byte[] cells = levels[level];
    int both = right * down >> 8;
    return (MipMap.ONE - right - down + both) * (cells[above + x0] & 0xFF)
        + (right - both) * (cells[above + x1] & 0xFF)
        + (down - both) * (cells[below + x0] & 0xFF)
        + both * (cells[below + x1] & 0xFF);
  }
}
