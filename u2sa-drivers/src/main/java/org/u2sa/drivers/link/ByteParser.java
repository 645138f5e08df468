package org.u2sa.drivers.link;

/**
 * Makes sense of a device's bytes, however they came: serial line, network, a UART of the IOIO, a
 * recording. The bytes may be cut anywhere, and be garbage: what cannot be understood is counted
 * and passed over.
 *
 * <p>For one thread.
 */
public interface ByteParser {
  /**
   * Takes the next bytes of the stream.
   *
   * @param length how many of {@code bytes} count, from the beginning
   * @param nowMicros when they came [µs of the run's clock]: the time of the readings in them
   */
  void accept(byte[] bytes, int length, long nowMicros);

  /** Forgets what is half received, as after a loss of the device; the newest reading stays. */
  void reset();

  /** How many messages were refused so far: wrong checksum, cut off, out of range. */
  long refused();

  /** Why the last of {@link #refused} was, for the log; empty if none was. */
  String lastRefusal();
}
