package org.u2sa.recorder.mcap;

import java.util.EnumSet;
import java.util.Set;

/**
 * How a file is written.
 *
 * @param features what it contains
 * @param compression of chunks
 * @param chunkBytes how long a chunk grows before it is written, uncompressed [B]
 * @param chunkNanos how much time a chunk spans before it is written, by log time [ns]
 * @param profile for the header; empty: none
 * @param library for the header: who wrote it
 */
public record McapOptions(
    Set<McapFeature> features,
    ChunkCompression compression,
    int chunkBytes,
    long chunkNanos,
    String profile,
    String library) {
  private static final int USUAL_CHUNK_BYTES = 1 << 20;
  private static final long USUAL_CHUNK_NANOS = 500_000_000L;

  public McapOptions {
    features = Set.copyOf(features);
    if (chunkBytes < 1 || chunkNanos < 1) {
      throw new IllegalArgumentException(
          "chunks of " + chunkBytes + " B, " + chunkNanos + " ns: expected at least 1 of each");
    }
  }

  /** All indexes, and chunks of at most half a second or about 1 MiB. */
  public static McapOptions usual(ChunkCompression compression, String library) {
    return new McapOptions(
        EnumSet.complementOf(EnumSet.of(McapFeature.LATER_FIELDS)),
        compression,
        USUAL_CHUNK_BYTES,
        USUAL_CHUNK_NANOS,
        "",
        library);
  }

  boolean has(McapFeature feature) {
    return features.contains(feature);
  }
}
