package org.u2sa.recorder.mcap;

/** How much of a file is held in memory, whatever the file says of itself. */
final class ReadLimits {
  /** No record is longer, and no chunk when it is decompressed: what says so is damaged [B]. */
  static final long MAX_LENGTH = 1L << 30;

  /** Messages take up to four times their bytes in a chunk, which is held beside them. */
  private static final int SHARE_OF_HEAP = 6;

  private ReadLimits() {}

  /** Bytes of chunks that a reader holds at a time, on this machine's heap. */
  static long heldBytes() {
    return Math.min(MAX_LENGTH, Runtime.getRuntime().maxMemory() / SHARE_OF_HEAP);
  }
}
