package org.u2sa.drivers.gps;

import java.util.function.Consumer;
import org.u2sa.drivers.link.BinaryFramer;

/**
 * UBX messages: {@code B5 62 class id length payload checksum}, little-endian (u-blox 6 Receiver
 * Description, GPS.G6-SW-10018, section 24). Other bytes, such as NMEA, are skipped.
 */
final class UbxFramer extends BinaryFramer {
  private static final int OVERHEAD = 8; // header and checksum
  private static final int SYNC_1 = 0xB5;
  private static final int SYNC_2 = 0x62;
  private static final int HEADER = 6;
  private static final int LONGEST_PAYLOAD = 1_024; // longer than any requested message

  private final Consumer<UbxPayload> sink;

  /**
   * @param sink receives messages, each valid only during the call
   * @param refusals receives the reason of each rejection
   */
  UbxFramer(Consumer<UbxPayload> sink, Consumer<String> refusals) {
    super(LONGEST_PAYLOAD + OVERHEAD, refusals);
    this.sink = sink;
  }

  /** Encodes a message. */
  static byte[] frame(int messageClass, int id, byte... payload) {
    byte[] frame = new byte[payload.length + OVERHEAD];
    frame[0] = (byte) SYNC_1;
    frame[1] = SYNC_2;
    frame[2] = (byte) messageClass;
    frame[3] = (byte) id;
    frame[4] = (byte) payload.length;
    frame[5] = (byte) (payload.length >> 8);
    System.arraycopy(payload, 0, frame, HEADER, payload.length);
    int sum = checksum(frame, 2, HEADER + payload.length);
    frame[HEADER + payload.length] = (byte) sum;
    frame[HEADER + payload.length + 1] = (byte) (sum >> 8);
    return frame;
  }

  /** Fletcher checksum over class, id, length and payload; the second sum is in the high byte. */
  private static int checksum(byte[] bytes, int from, int to) {
    int first = 0;
    int second = 0;
    for (int i = from; i < to; i++) {
      first = first + bytes[i] & 0xFF;
      second = second + first & 0xFF;
    }
    return second << 8 | first;
  }

  @Override
  protected int lengthAt(int at, int available) {
    if (unsigned8(at) != SYNC_1 || available > 1 && unsigned8(at + 1) != SYNC_2) {
      return NONE;
    }
    if (available < HEADER) {
      return HEADER;
    }
    int length = unsigned16(at + 4);
    if (length > LONGEST_PAYLOAD) {
      refuse(message(at) + length + " bytes long");
      return NONE;
    }
    return length + OVERHEAD;
  }

  private String message(int at) {
    return String.format("UBX message %02X-%02X: ", unsigned8(at + 2), unsigned8(at + 3));
  }

  @Override
  protected String fault(int at, int length) {
    int end = at + length - 2;
    int sum = checksum(bytes(), at + 2, end);
    return sum == unsigned16(end) ? "" : message(at) + "wrong checksum";
  }

  @Override
  protected void take(int at, int length) {
    int kind = unsigned8(at + 2) << 8 | unsigned8(at + 3);
    sink.accept(new UbxPayload(bytes(), kind, at + HEADER, length - OVERHEAD));
  }
}
