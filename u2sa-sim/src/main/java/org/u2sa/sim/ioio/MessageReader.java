package org.u2sa.sim.ioio;

/** Cuts the bytes to the board into messages, wherever the connection cut them. */
final class MessageReader {
  private static final int SIX_BITS = 0x3F;

  /** Takes whole messages; returns false if one is wrong, which ends the connection. */
  interface Handler {
    boolean handle(int type, Bits arguments);
  }

  private final byte[] message = new byte[Message.LONGEST];
  private int length;

  /** Forgets a message that is half there. */
  void reset() {
    length = 0;
  }

  /** Takes bytes; returns false at the first message that the board does not take. */
  boolean accept(byte[] bytes, int offset, int count, Handler handler) {
    for (int i = offset; i < offset + count; i++) {
      message[length++] = bytes[i];
      int missing = missing();
      if (missing < 0) {
        return false;
      }
      if (missing == 0) {
        Bits arguments = new Bits(message, 1, length - 1);
        length = 0;
        if (!handler.handle(message[0] & 0xFF, arguments)) {
          return false;
        }
      }
    }
    return true;
  }

  private int missing() {
    int type = message[0] & 0xFF;
    int fixed = Message.argumentLength(type);
    if (fixed < 0) {
      return -1;
    }
    int whole = 1 + fixed;
    if (type == Message.UART_DATA && length > 1) {
      whole += (message[1] & SIX_BITS) + 1;
    }
    return whole - length;
  }
}
