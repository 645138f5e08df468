package org.u2sa.drivers.ioio;

import ioio.lib.api.IOIO;
import ioio.lib.api.IOIOFactory;
import ioio.lib.api.exception.ConnectionLostException;
import ioio.lib.api.exception.IncompatibilityException;
import ioio.lib.api.exception.OutOfResourceException;
import java.util.Optional;

/** One attempt to reach the board, and if it succeeds, the connection until its end. */
final class BoardSession {
  private final GuardedConnection guarded;
  private final IOIO ioio;
  private volatile BoardPins pins; // null until connected
  private volatile String blame = ""; // why it was given up

  /** Does nothing yet. */
  BoardSession(BoardConnection connection) {
    guarded = new GuardedConnection(connection.newConnection(), connection.isLockstep());
    ioio = IOIOFactory.create(guarded);
  }

  /**
   * Waits for the board and opens the pins. The library's own threads inherit that they are daemons
   * from the thread that calls.
   *
   * @return why it failed; empty if the board is there
   */
  String connect(PinPlan plan) {
    try {
      ioio.waitForConnect();
      pins = guarded.whileUp(() -> new BoardPins(ioio, plan));
      return "";
    } catch (ConnectionLostException e) {
      Throwable cause = e.getCause();
      String reason =
          cause == null || cause.getMessage() == null
              ? "it does not answer, or ended the connection"
              : cause.getMessage();
      return failed(reason);
    } catch (IncompatibilityException e) {
      return failed(e.getMessage());
    } catch (IllegalArgumentException | IllegalStateException | OutOfResourceException e) {
      return failed(String.valueOf(e.getMessage())); // the pins are not this board's; interrupted
    }
  }

  private String failed(String reason) {
    disconnect();
    return blame.isEmpty() ? reason : blame;
  }

  /** What the board and the library say they are. */
  String versions() {
    return "hardware "
        + ioio.getImplVersion(IOIO.VersionType.HARDWARE_VER)
        + ", boot loader "
        + ioio.getImplVersion(IOIO.VersionType.BOOTLOADER_VER)
        + ", firmware "
        + ioio.getImplVersion(IOIO.VersionType.APP_FIRMWARE_VER)
        + ", library "
        + ioio.getImplVersion(IOIO.VersionType.IOIOLIB_VER);
  }

  /** The pins; only after {@link #connect} has succeeded. */
  BoardPins pins() {
    return pins;
  }

  /** Counts in lockstep what the library sends; empty in real time. */
  Optional<FlushCounter> lockstep() {
    return guarded.flushes();
  }

  /** In lockstep, once it is connected: has the library take bytes on the calling thread. */
  void take(byte[] bytes) {
    pins.comes(bytes);
    guarded.take(bytes);
  }

  GuardedConnection link() {
    return guarded;
  }

  /** Whether the board is there, as far as is known. */
  boolean isUp() {
    return !guarded.hasEnded() && blame.isEmpty();
  }

  /** Gives it up for a reason; to be disconnected. */
  void giveUp(String reason) {
    blame = reason;
  }

  /**
   * Waits for the end of the connection, when the library has told everyone.
   *
   * @return why it ended
   */
  String awaitEnd() throws InterruptedException {
    ioio.waitForDisconnect();
    return blame.isEmpty() ? "the connection has ended" : blame;
  }

  /** Ends the connection, or the attempt. From any thread. */
  void disconnect() {
    ioio.disconnect();
  }
}
