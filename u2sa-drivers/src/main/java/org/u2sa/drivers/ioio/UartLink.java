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

  private Optional<UartLine> line = Optional.empty(); // of the present connection
  private int connections;
  private boolean isUnseen; // the owner does not know of the present connection yet
  private String trouble = "the IOIO is not there";

  /** The board is there, with this line. */
  void attach(UartLine newLine) {
    if (line.filter(newLine::equals).isEmpty()) {
      line = Optional.of(newLine);
      connections++;
      isUnseen = true;
      trouble = "";
    }
  }

  /** The board is not there. */
  void detach() {
    line = Optional.empty();
    trouble = "the IOIO is not there";
  }

  /**
   * Sends what waits, as fast as the line takes it.
   *
   * @param lockstep waits for the library's sending; empty in real time
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
      trouble = "the IOIO is lost: " + e.getMessage();
      line = Optional.empty();
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
    detach();
  }
}
