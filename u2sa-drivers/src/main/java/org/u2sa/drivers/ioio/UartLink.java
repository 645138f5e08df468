package org.u2sa.drivers.ioio;

import java.io.IOException;
import java.util.Optional;
import org.u2sa.drivers.link.ByteLink;

/**
 * The way to a device at a UART of the board, over all connections to the board. What is written
 * leaves at the end of the service's step. Belongs to the service's thread.
 */
final class UartLink implements ByteLink {
  private static final int MOST_WAITING = 512;
  private static final String NOT_THERE = "the IOIO is not there";

  private Optional<UartLine> line = Optional.empty(); // of the present connection
  private int connections;
  private boolean isUnseen; // the owner does not know of the present connection yet
  private String trouble = NOT_THERE;

  /** Takes note of the line of the present connection to the board, or that there is none. */
  void attach(Optional<UartLine> newLine) {
    if (newLine.isPresent() && newLine.get() != line.orElse(null)) {
      connections++;
      isUnseen = true;
    }
    line = newLine;
    trouble = line.isPresent() ? "" : NOT_THERE;
  }

  /**
   * Sends what waits, as fast as the line takes it.
   *
   * @param lockstep counts what the library sends, and all is sent on return; empty in real time
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
      trouble = "the IOIO is lost: " + e.getMessage(); // which the keeper of the board notices, too
      return 0;
    }
  }

  @Override
  public boolean write(byte[] bytes) {
    if (line.isEmpty() || line.get().waiting() + bytes.length > MOST_WAITING) {
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
    return trouble;
  }

  @Override
  public void close() {
    attach(Optional.empty());
  }
}
