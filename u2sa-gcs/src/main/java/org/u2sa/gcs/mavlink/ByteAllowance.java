package org.u2sa.gcs.mavlink;

/**
 * Limits the bytes handled per link, on average and in a burst. Each message, or byte that looks
 * like the start of one, counts as 400 extra bytes because it costs a checksum of 280 bytes.
 */
final class ByteAllowance {
  private static final double BYTES_PER_S = 100_000.0;
  private static final double BURST = 400_000.0;
  private static final double PER_MESSAGE = 400; // a message costs more time than its bytes
  private static final double MICROS_PER_S = 1.0e6;

  private double left = BURST;
  private long filledMicros = Long.MIN_VALUE;

  /** Number of bytes that may be handled at present. */
  int left(long nowMicros) {
    if (filledMicros != Long.MIN_VALUE) {
      left = Math.min(BURST, left + BYTES_PER_S * (nowMicros - filledMicros) / MICROS_PER_S);
    }
    filledMicros = nowMicros;
    return (int) left;
  }

  void use(int bytes) {
    left -= bytes;
  }

  /** Counts handled messages and false packet starts. */
  void useMessages(long count) {
    left -= PER_MESSAGE * count;
  }
}
