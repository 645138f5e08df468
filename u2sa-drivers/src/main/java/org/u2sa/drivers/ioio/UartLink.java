package org.u2sa.drivers.ioio;

import java.io.IOException;
import java.util.Optional;
import org.u2sa.drivers.link.ByteLink;

/**
 * Link to a device on a board UART, persisting across board connections. Output is sent at the end
 * of the service's step. Confined to the service's thread.
 */
final class UartLink implements ByteLink {
  private static final int MAX_WAITING = 512;
  private static final String NOT_THERE = "the IOIO is not connected";

  private final String device;
  private Optional<UartLine> line = Optional.empty(); // current connection
  private int connections;
  private boolean isUnseen; // the owner has not been notified of the current connection yet
  private String trouble = NOT_THERE;

  /**
   * @param device named in faults
   */
  UartLink(String device) {
    this.device = device;
  }

  /** Sets the line of the current board connection; empty while disconnected. */
  void attach(Optional<UartLine> newLine) {
    if (newLine.isPresent() && newLine.get() != line.orElse(null)) {
      connections++;
      isUnseen = true;
    }
    line = newLine;
    trouble = line.isPresent() ? "" : NOT_THERE;
  }

  /**
   * Sends pending bytes, paced to the line rate.
   *
   * @param lockstep counter of the library's output; all is sent on return. Empty in real time
   */
  void send(long nowMicros, Optional<FlushCounter> lockstep) throws IOException {
    if (line.isPresent()) {
      line.get().send(nowMicros, lockstep);
    }
  }

  @Override
  public int read(byte[] buffer) {
    if (line.isEmpty() || isUnseen) {
      isUnseen = false;
      return 0;
    }
    try {
      return line.get().read(buffer);
    } catch (IOException e) {
      trouble =
          "the IOIO is lost: " + e.getMessage(); // the board's supervisor notices this as well
      return 0;
    }
  }

  @Override
  public boolean write(byte[] bytes) {
    if (line.isEmpty() || line.get().waiting() + bytes.length > MAX_WAITING) {
      return false;
    }
    line.get().write(bytes);
    return true;
  }

  @Override
  public boolean isConnected() {
    return line.isPresent();
  }

  @Override
  public int connections() {
    isUnseen = false;
    return connections;
  }

  @Override
  public String trouble() {
    boolean isFull = trouble.isEmpty() && line.isPresent() && line.get().isFull();
    return isFull ? "the IOIO takes no bytes for " + device : trouble;
  }

  @Override
  public void close() {
    attach(Optional.empty());
  }
}
