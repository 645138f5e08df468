package org.u2sa.drivers.link;

/**
 * Reads the bytes waiting on a link, up to a limit: a device, or a stranger on the network, that
 * sends faster than its reader parses must not keep a service from its other work, such as an
 * emergency stop. The rest is read at the next call.
 */
public final class PendingBytes {
  /** Maximum number of bytes per call, about as many as a link buffers. */
  static final int MAX_BYTES = 1 << 16;

  private final byte[] buffer = new byte[4_096];

  /** Receives bytes. */
  @FunctionalInterface
  public interface Sink {
    /** Handles the first {@code length} bytes, which are valid only during this call. */
    void accept(byte[] bytes, int length);
  }

  /** Delivers the waiting bytes in portions. */
  public void read(ByteLink link, Sink sink) {
    int count;
    for (int all = 0; all < MAX_BYTES && (count = link.read(buffer)) > 0; all += count) {
      sink.accept(buffer, count);
    }
  }
}
