package org.u2sa.drivers.link;

import org.u2sa.device.port.Attached;

/**
 * A bidirectional byte stream to a device: serial line, TCP, UDP, an IOIO UART, simulated or
 * replayed. An absent device is a state, not an exception: the link reconnects automatically. No
 * call blocks on the device.
 *
 * <p>Reads and writes belong to one thread; {@link #close} is thread-safe.
 */
public interface ByteLink extends Attached, AutoCloseable {
  /**
   * Reads the bytes received since the last call.
   *
   * @param buffer filled from index 0
   * @return number of bytes; 0 if nothing was received or the device is absent, and once after each
   *     reconnection not yet visible in {@link #connections}, so that its bytes are never joined to
   *     earlier ones. Bytes unread before a reconnection are dropped
   */
  int read(byte[] buffer);

  /**
   * Queues bytes for sending, all or none.
   *
   * @return false if the device is absent or the queue is full; nothing was queued then
   */
  boolean write(byte[] bytes);

  @Override
  void close();
}
