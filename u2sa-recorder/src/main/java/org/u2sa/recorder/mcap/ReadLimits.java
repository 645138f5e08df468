package org.u2sa.recorder.mcap;

/** Memory limits for reading, independent of the sizes a file claims. */
final class ReadLimits {
  /** Maximum size of a record or decompressed chunk [B]; a larger claim means damage. */
  static final long MAX_LENGTH = 1L << 30;

  /** Messages occupy up to four times their size in the chunk, which is held as well. */
  private static final int SHARE_OF_HEAP = 6;

  private ReadLimits() {}

  /** Limit of chunk bytes held by a reader, given this machine's heap. */
  static long heldBytes() {
    return Math.min(MAX_LENGTH, Runtime.getRuntime().maxMemory() / SHARE_OF_HEAP);
  }
}
