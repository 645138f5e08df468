package org.u2sa.drivers.link;

import java.io.Closeable;
import java.io.IOException;

/** An open connection to a device, until it is lost. */
public interface Port extends Closeable {
  /** Maximum time {@link #read} blocks [ms]. */
  int PATIENCE_MS = 100;

  /**
   * Reads bytes, waiting briefly.
   *
   * @return number of bytes; 0 if none arrived within {@link #PATIENCE_MS}
   * @throws IOException if the device is lost
   */
  int read(byte[] buffer) throws IOException;

  /**
   * Sends all bytes; may block on the device.
   *
   * @throws IOException if the device is lost
   */
  void write(byte[] bytes) throws IOException;

  /** Whether sending is possible now. */
  default boolean isWritable() {
    return true;
  }

  /**
   * Whether the device's presence is known only from received data, because opening does not reach
   * it.
   */
  default boolean isFoundBySpeaking() {
    return false;
  }

  /** Opens a device. */
  interface Opener {
    /**
     * Opens the device, within about a second.
     *
     * @throws IOException if it is absent; the message gives the reason
     */
    Port open() throws IOException;
  }
}
