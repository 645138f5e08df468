package org.u2sa.drivers.ioio;

import ioio.lib.api.IOIO;
import ioio.lib.api.IOIOFactory;
import ioio.lib.api.exception.ConnectionLostException;
import ioio.lib.api.exception.IncompatibilityException;
import ioio.lib.api.exception.OutOfResourceException;
import java.util.Optional;
import java.util.OptionalLong;

/** One connection attempt and, if it succeeds, the connection until its end. */
final class BoardSession {
  private final GuardedConnection guarded;
  private final IOIO ioio;
  private final Optional<BoardEcho> echo; // none in lockstep
  private volatile BoardPins pins; // null until connected
  private volatile String blame = ""; // reason for giving up

  /**
   * Idle until {@link #connect}.
   *
   * @param askEveryMs pause between an answer of the board and the next query; unused in lockstep
   */
  BoardSession(BoardConnection connection, long askEveryMs) {
    guarded = new GuardedConnection(connection.newConnection(), connection.isLockstep());
    ioio = IOIOFactory.create(guarded);
    echo =
        connection.isLockstep() ? Optional.empty() : Optional.of(new BoardEcho(ioio, askEveryMs));
  }

  /**
   * Waits for the board and opens the pins. The library's threads inherit daemon status from the
   * calling thread.
   *
   * @return reason for failure; empty on success
   */
  String connect(PinPlan plan) {
    try {
      ioio.waitForConnect();
      pins = guarded.whileUp(() -> new BoardPins(ioio, plan));
      if (echo.isPresent()) {
        guarded.start(echo.get());
      }
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
      return failed(String.valueOf(e.getMessage())); // pins invalid for this board, or interrupted
    }
  }

  private String failed(String reason) {
    disconnect();
    return blame.isEmpty() ? reason : blame;
  }

  /** Versions reported by the board and the library. */
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

  /** The pins; valid only after a successful {@link #connect}. */
  BoardPins pins() {
    return pins;
  }

  /** Counter of the library's output in lockstep; empty in real time. */
  Optional<FlushCounter> lockstep() {
    return guarded.flushes();
  }

  /** In lockstep, once connected: lets the library consume bytes on the calling thread. */
  void take(byte[] bytes) {
    pins.comes(bytes);
    guarded.take(bytes);
  }

  GuardedConnection link() {
    return guarded;
  }

  /** Number of queries that the board has answered; empty in lockstep, which sends none. */
  OptionalLong answers() {
    return echo.isPresent() ? OptionalLong.of(echo.get().answers()) : OptionalLong.empty();
  }

  /** Sends the next query without the usual pause. */
  void askNow() {
    echo.ifPresent(BoardEcho::askNow);
  }

  /** Whether the board is connected, as far as known. */
  boolean isUp() {
    return !guarded.hasEnded() && blame.isEmpty();
  }

  /** Marks the session as given up, with a reason; the caller disconnects it. */
  void giveUp(String reason) {
    blame = reason;
  }

  /**
   * Waits until the connection has ended and the library has notified its objects.
   *
   * @return reason for the end
   */
  String awaitEnd() throws InterruptedException {
    ioio.waitForDisconnect();
    return blame.isEmpty() ? "the connection has ended" : blame;
  }

  /** Ends the connection or attempt. Thread-safe. */
  void disconnect() {
    ioio.disconnect();
  }
}
