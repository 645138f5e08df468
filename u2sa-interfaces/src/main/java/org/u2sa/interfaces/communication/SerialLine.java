package org.u2sa.interfaces.communication;

import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;

/**
 * A serial port, for programs that may not depend on drivers. It reconnects by itself; no call
 * blocks. Reads and writes belong to one thread.
 */
public interface SerialLine extends AutoCloseable {
  /** Opens serial ports; found by {@link java.util.ServiceLoader}. */
  interface Provider {
    /**
     * Opens a port with 8 data bits, no parity and no flow control. Returns at once; the port may
     * be absent.
     *
     * @param path device file, such as /dev/ttyUSB0
     * @param baud bits per second
     * @throws BadInputException if path or rate cannot be
     */
    SerialLine open(String path, int baud, Clock clock);
  }

  /**
   * Reads what has arrived.
   *
   * @param buffer filled from index 0
   * @return number of bytes; 0 if nothing arrived or the port is absent
   */
  int read(byte[] buffer);

  /**
   * Queues bytes for sending, all or none.
   *
   * @return false if the port is absent or the queue is full
   */
  boolean write(byte[] bytes);

  @Override
  void close();
}
