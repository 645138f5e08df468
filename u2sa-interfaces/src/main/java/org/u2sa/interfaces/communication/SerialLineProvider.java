package org.u2sa.interfaces.communication;

import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;

/** Opens serial ports; found by {@link java.util.ServiceLoader}. */
public interface SerialLineProvider {
  /**
   * Opens a port with 8 data bits, no parity and no flow control. Returns at once; the port may be
   * absent.
   *
   * @param path device file, such as /dev/ttyUSB0
   * @param baud bits per second
   * @throws BadInputException if path or rate is invalid
   */
  SerialLine open(String path, int baud, Clock clock);
}
