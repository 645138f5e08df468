package org.u2sa.drivers.link;

import java.io.Closeable;
import java.io.IOException;

/** A device that was found and opened, until it is lost. */
public interface Port extends Closeable {
  /** The longest that {@link #read} waits [ms]. */
  int PATIENCE_MS = 100;

  /**
   * Waits for bytes, a little.
   *
   * @return how many came; 0 if none came within {@link #PATIENCE_MS}
   * @throws IOException if the device is lost
   */
  int read(byte[] buffer) throws IOException;

  /**
   * Sends all bytes; may wait for the device.
   *
   * @throws IOException if the device is lost
   */
  void write(byte[] bytes) throws IOException;

  /** Whether something may be sent now. */
  default boolean isWritable() {
    return true;
  }

  /** Whether it is only known to be there when it speaks, since opening does not reach it. */
  default boolean isFoundBySpeaking() {
    return false;
  }

  /** A way to open a device. */
  interface Opener {
    /**
     * Opens it, within about a second.
     *
     * @throws IOException if it is not there; the message says what is wrong
     */
    Port open() throws IOException;
  }
}
