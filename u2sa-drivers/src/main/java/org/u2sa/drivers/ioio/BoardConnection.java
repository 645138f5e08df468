package org.u2sa.drivers.ioio;

import ioio.lib.api.IOIOConnection;
import java.util.function.Consumer;
import org.u2sa.interfaces.BadInputException;

/**
 * Transport to an IOIO: serial, TCP, an Android phone's Bluetooth or USB, or an in-process
 * simulated board. Creates a new IOIOLib connection for each attempt.
 */
public interface BoardConnection {
  /**
   * Creates an unopened connection for one attempt. Its {@code waitForConnect} may block; {@code
   * disconnect} from another thread ends the wait and any read.
   */
  IOIOConnection newConnection();

  /** Address shown in the log. */
  String address();

  /**
   * Whether the board's time advances only in {@link #exchange} (lockstep). Connecting is then
   * immediate, no call waits for the board, and runs are bit-identical.
   */
  default boolean isLockstep() {
    return false;
  }

  /**
   * Advances the board to a time of the run [µs] and returns once the IOIO library has consumed the
   * resulting bytes. No effect in real time.
   *
   * @param reader lets the library consume bytes on the calling thread; used only while the
   *     library's reading thread waits on the current connection, which then receives none of them
   */
  default void exchange(long nowMicros, Consumer<byte[]> reader) {}

  /**
   * Connection for an address: {@code serial:/dev/ttyACM0} (IOIO-OTG on USB) or {@code
   * tcp:host:port}.
   *
   * @throws BadInputException if the address is invalid
   */
  static BoardConnection of(String address) {
    return PortConnection.at(address);
  }
}
