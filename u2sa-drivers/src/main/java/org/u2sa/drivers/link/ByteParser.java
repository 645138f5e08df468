package org.u2sa.drivers.link;

import java.util.Optional;

/**
 * Makes sense of a device's bytes, however they came: serial line, network, a UART of the IOIO, a
 * recording. The bytes may be cut anywhere, and be garbage: what cannot be understood is counted
 * and passed over.
 *
 * <p>For one thread.
 *
 * @param <R> what it makes of them
 */
public interface ByteParser<R> {
  /**
   * Takes the next bytes of the stream.
   *
   * @param length how many of {@code bytes} count, from the beginning
   * @param nowMicros when they came [µs of the run's clock]: the time of the readings in them
   */
  void accept(byte[] bytes, int length, long nowMicros);

  /** Forgets what is half received, as after a loss of the device; the newest reading stays. */
  void reset();

  /** The newest reading; empty before the first. A new object for each, the same until the next. */
  Optional<R> latest();

  /** How many messages were refused so far: wrong checksum, cut off, out of range. */
  long refused();

  /** Why the last of {@link #refused} was, for the log; empty if none was. */
  String lastRefusal();
}
