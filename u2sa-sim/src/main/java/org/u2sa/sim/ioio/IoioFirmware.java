package org.u2sa.sim.ioio;

import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * The firmware of a simulated IOIO, version IOIO0506: host bytes in, host bytes out, with the pins
 * in between. Responses match the real firmware byte for byte for digital pins, PWM, UARTs, analog
 * and pulse inputs. SPI, I²C, ICSP, capacitive sensing and the sequencer are not implemented;
 * requesting them ends the connection, like an invalid byte.
 *
 * <p>Free of sockets, threads and clocks; {@link IoioInProcess} and {@link IoioTcpServer} serve it.
 * Not thread-safe.
 */
public final class IoioFirmware {
  private static final String FIRMWARE = "IOIO0506";
  private static final String MAGIC = "IOIO";
  private static final int SEND_QUEUE = 8192;
  private static final long TICK_MICROS = 1000;

  private enum State {
    CLOSED,
    OPEN,
    CLOSING
  }

  private final IoioBoard board;
  private final Pins world;
  private final ByteQueue out = new ByteQueue(SEND_QUEUE);
  private final MessageReader reader = new MessageReader();
  private final Peripherals peripherals;
  private final Commands commands;
  private State state = State.CLOSED;
  private String trouble = "";
  private long tickMicros;
  private boolean hasTicked;

  /** Creates a powered-up board without a connection. */
  public IoioFirmware(IoioBoard board, Pins world) {
    this.board = board;
    this.world = world;
    peripherals = new Peripherals(board, world, out);
    commands = new Commands(board, peripherals, out);
    peripherals.reset();
  }

  /** Opens a connection and sends the board's identification; drops an existing connection. */
  public void open() {
    lost();
    reader.reset();
    state = State.OPEN;
    trouble = "";
    out.push(Message.ESTABLISH_CONNECTION);
    for (String text : new String[] {MAGIC, board.hardware(), board.bootloader(), FIRMWARE}) {
      byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
      out.push(bytes, 0, bytes.length);
    }
  }

  /** Ends the connection: resets all modules; all pins float. */
  public void lost() {
    state = State.CLOSED;
    out.clear();
    peripherals.reset();
  }

  /** Whether the board keeps the connection open; bytes for the host may still be pending. */
  public boolean isOpen() {
    return state != State.CLOSED;
  }

  /** Reason why the board closed the last connection; empty if it did not. */
  public String trouble() {
    return trouble;
  }

  /** Consumes host bytes, with arbitrary packet boundaries. */
  public void accept(byte[] bytes, int offset, int length) {
    if (state == State.CLOSED || length == 0) {
      return;
    }
    if (state == State.CLOSING) {
      refuse("bytes after the soft close");
    } else if (!reader.accept(bytes, offset, length, this::handle)) {
      if (state == State.OPEN && trouble.isEmpty()) {
        refuse("a message type the board does not accept");
      }
      return;
    }
    peripherals.report();
  }

  private boolean handle(int type, MessageReader.Bits arguments) {
    if (state != State.OPEN) {
      refuse("bytes after the soft close");
      return false;
    }
    if (type == Message.SOFT_CLOSE) {
      out.push(Message.SOFT_CLOSE);
      state = State.CLOSING;
      return true;
    }
    if (type == Message.HARD_RESET) {
      refuse(
          arguments.text().equals(MAGIC)
              ? "hard reset"
              : "hard reset with a wrong magic word: \"" + arguments.text() + '"');
      return false;
    }
    boolean taken = commands.handle(type, arguments);
    if (!taken) {
      refuse(String.format(Locale.ROOT, "message 0x%02X with arguments out of range", type));
    }
    return taken;
  }

  private void refuse(String why) {
    lost();
    trouble = why;
  }

  /**
   * Advances the board and its pins to a time of the run [µs]; the first call only sets the start
   * time. Earlier times are ignored.
   */
  public void advance(long nowMicros) {
    if (!hasTicked) {
      hasTicked = true;
      tickMicros = nowMicros;
      world.advance(nowMicros);
      peripherals.tick(nowMicros); // later configuration takes effect from this time
    }
    while (nowMicros - tickMicros >= TICK_MICROS) {
      tickMicros += TICK_MICROS;
      world.advance(tickMicros);
      peripherals.tick(tickMicros);
    }
  }

  /**
   * Removes pending bytes for the host. After a soft close, removing the last bytes ends the
   * connection.
   *
   * @param buffer filled from index 0
   * @return number of bytes, 0 if none
   */
  public int output(byte[] buffer) {
    int count = out.pull(buffer, buffer.length);
    if (state == State.CLOSING && out.size() == 0) {
      lost();
    }
    return count;
  }
}
