package org.u2sa.recorder.mcap;

import java.util.EnumSet;
import java.util.Set;

/**
 * Options of a writer.
 *
 * @param features optional contents
 * @param compression compression of chunks
 * @param chunkBytes uncompressed chunk size at which it is written [B]
 * @param chunkNanos log-time span of a chunk at which it is written [ns]
 * @param profile profile in the header; empty if none
 * @param library writing library, for the header
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
