package org.u2sa.drivers.ioio;

import ioio.lib.api.IOIOConnection;
import java.util.function.Consumer;
import org.u2sa.interfaces.BadInputException;

/**
 * A way to a IOIO: serial, TCP, an Android phone's Bluetooth or USB, or a simulated board within
 * the process. It makes a new connection of the IOIO library for each attempt to reach the board.
 */
public interface BoardConnection {
  /**
   * A connection that has not been opened yet, for one attempt. Its {@code waitForConnect} may take
   * its time; its {@code disconnect} ends that, and ends reading, from any other thread.
   */
  IOIOConnection newConnection();

  /** What the connection is called in the log: its address. */
  String address();

  /**
   * Whether the board's time moves in {@link #exchange} only. Then connecting takes no time, no
   * call waits for the board, and runs repeat bit for bit.
   */
  default boolean isLockstep() {
    return false;
  }

  /**
   * Lets the board's time pass to a time of the run [µs], and returns when the IOIO library has
   * taken every byte that came of it. In real time there is nothing to do.
   *
   * @param reader has the library take bytes on the calling thread; only for when the library's
   *     reading thread waits for bytes of the present connection, and then gets none of them
   */
  default void exchange(long nowMicros, Consumer<byte[]> reader) {}

  /**
   * The connection that an address names: {@code serial:/dev/ttyACM0} (IOIO-OTG on USB) or {@code
   * tcp:host:port}.
   *
   * @throws BadInputException if it names none
   */
  static BoardConnection of(String address) {
    return PortConnection.at(address);
  }
}
