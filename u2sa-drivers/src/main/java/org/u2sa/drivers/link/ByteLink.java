package org.u2sa.drivers.link;

import org.u2sa.device.Attached;

/**
 * A two-way stream of bytes to a device: serial line, TCP or UDP, a UART of the IOIO, simulated or
 * replayed. A device that is not there is a state, not an exception: the link looks for it again by
 * itself. No call waits for the device.
 *
 * <p>One thread reads and writes; {@link #close} may come from any.
 */
public interface ByteLink extends Attached, AutoCloseable {
  /**
   * Takes what has come since the last call.
   *
   * @param buffer filled from its beginning
   * @return the number of bytes; 0 if nothing came or the device is not there, and once for each
   *     new connection that the owner has not yet seen in {@link #connections}: so that no byte of
   *     it is taken for a part of what came before. Bytes that were not read before a new
   *     connection are dropped
   */
  int read(byte[] buffer);

  /**
   * Hands bytes over for sending, all or none.
   *
   * @return false if the device is not there or does not take them now; nothing was sent then
   */
  boolean write(byte[] bytes);

  @Override
  void close();
}
