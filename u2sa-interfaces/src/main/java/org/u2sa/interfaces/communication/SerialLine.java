package org.u2sa.interfaces.communication;

/**
 * A serial port, for modules that must not depend on drivers. It reconnects by itself; no call
 * blocks. Reads and writes belong to one thread.
 */
public interface SerialLine extends AutoCloseable {
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
