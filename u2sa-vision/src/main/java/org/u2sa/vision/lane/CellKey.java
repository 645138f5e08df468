package org.u2sa.vision.lane;

/** Column and row of a cell as one number. */
final class CellKey {
  // Without it, all cells of a diagonal would have the same hash code, which is the exclusive or of
  // both halves. Multiplication by an odd number is reversible (Knuth, TAOCP 3, section 6.4).
  private static final long SPREAD = 0x9E37_79B9_7F4A_7C15L;
  private static final long GATHER = 0xF1DE_83E1_9937_733DL; // SPREAD * GATHER = 1

  private CellKey() {}

  static long of(long column, long row) {
    return (column << 32 | row & 0xFFFF_FFFFL) * SPREAD;
  }

  static long column(long key) {
    return key * GATHER >> 32;
  }

  static long row(long key) {
    return (int) (key * GATHER);
  }
}
