package org.u2sa.sim.ioio;

import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * The firmware of a simulated IOIO, version IOIO0506: bytes of the host in, bytes to the host out,
 * and the pins in between. It answers byte for byte as the firmware does for digital pins, PWM,
 * UARTs, analog and pulse inputs; SPI, I²C, ICSP, capacitive sensing and the sequencer are not
 * there, and asking for them ends the connection as a wrong byte does.
 *
 * <p>It knows no socket, thread or clock: {@link IoioInProcess} and {@link IoioTcpServer} serve it.
 * For one thread at a time.
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

  /** A board that was just switched on, without a connection. */
  public IoioFirmware(IoioBoard board, Pins world) {
    this.board = board;
    this.world = world;
    peripherals = new Peripherals(board, world, out);
    commands = new Commands(board, peripherals, out);
    peripherals.reset();
  }

  /** The host has opened a connection: the board says who it is. One that was there is lost. */
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

  /** The connection is gone: everything is off and all pins float. */
  public void lost() {
    state = State.CLOSED;
    out.clear();
    peripherals.reset();
  }

  /** Whether the board holds the connection open; bytes for the host may wait. */
  public boolean isOpen() {
    return state != State.CLOSED;
  }

  /** Why the board closed the last connection by itself; empty if it did not. */
  public String trouble() {
    return trouble;
  }

  /** Takes bytes of the host, cut anywhere. */
  public void accept(byte[] bytes, int offset, int length) {
    if (state == State.CLOSED || length == 0) {
      return;
    }
    if (state == State.CLOSING) {
      refuse("bytes after the soft close");
    } else if (!reader.accept(bytes, offset, length, this::handle)) {
      if (state == State.OPEN && trouble.isEmpty()) {
        refuse("a message that the board does not take");
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
              : "hard reset without the word for it: \"" + arguments.text() + '"');
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
   * Lets time pass, in the board and at its pins, to a time of the run [µs]; the first call only
   * sets the watch. A time that has been is passed over.
   */
  public void advance(long nowMicros) {
    if (!hasTicked) {
      hasTicked = true;
      tickMicros = nowMicros;
      world.advance(nowMicros);
      peripherals.tick(nowMicros); // what is configured before the next tick counts from now
    }
    while (nowMicros - tickMicros >= TICK_MICROS) {
      tickMicros += TICK_MICROS;
      world.advance(tickMicros);
      peripherals.tick(tickMicros);
    }
  }

  /**
   * Takes bytes for the host. When the last ones after a soft close are taken, the connection ends.
   *
   * @param buffer filled from its beginning
   * @return how many; 0 if there are none
   */
  public int output(byte[] buffer) {
    int count = out.pull(buffer, buffer.length);
    if (state == State.CLOSING && out.size() == 0) {
      lost();
    }
    return count;
  }
}
