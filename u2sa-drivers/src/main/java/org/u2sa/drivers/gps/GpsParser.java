package org.u2sa.drivers.gps;

import java.util.Optional;

/**
 * Makes fixes of a receiver's bytes, however they came: serial line, network, a UART of the IOIO, a
 * recording. The bytes may be cut anywhere, and be garbage: what cannot be understood is counted
 * and passed over.
 *
 * <p>For one thread.
 */
public interface GpsParser {
  /**
   * Takes the next bytes of the stream.
   *
   * @param length how many of {@code bytes} count, from the beginning
   * @param nowMicros when they came [µs of the run's clock]: the time of the fixes in them
   */
  void accept(byte[] bytes, int length, long nowMicros);

  /** The newest fix; empty before the first. A new object for each fix, the same until the next. */
  Optional<GpsFix> latest();

  /** Forgets what is half received, as after a loss of the device; {@link #latest} stays. */
  void reset();

  /** How many messages were refused so far: wrong checksum, cut off, out of range. */
  long refused();

  /** Why the last of {@link #refused} was, for the log; empty if none was. */
  String lastRefusal();
}
