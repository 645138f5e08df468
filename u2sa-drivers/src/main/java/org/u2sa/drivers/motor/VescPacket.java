package org.u2sa.drivers.motor;

import java.util.Arrays;
import java.util.function.Consumer;
import org.u2sa.drivers.link.BinaryFramer;

/**
 * Packets of VESC's serial protocol: 2, length, payload, CRC-16 of the payload, 3 (vedderb/bldc,
 * {@code comm/packet.c}).
 */
final class VescPacket extends BinaryFramer {
  private static final int SHORT = 2;
  private static final int END = 3;
  private static final int HEAD_BYTES = 2;
  private static final int TAIL_BYTES = 3;
  private static final int LONGEST = 255;

  private final Consumer<byte[]> sink;

  /**
   * @param sink receives the payload of each packet
   * @param refusals receives the reason of each rejection
   */
  VescPacket(Consumer<byte[]> sink, Consumer<String> refusals) {
    super(HEAD_BYTES + LONGEST + TAIL_BYTES, refusals);
    this.sink = sink;
  }

  /** Encodes a payload of up to 255 bytes. */
  static byte[] of(byte... payload) {
    byte[] packet = new byte[HEAD_BYTES + payload.length + TAIL_BYTES];
    packet[0] = SHORT;
    packet[1] = (byte) payload.length;
    System.arraycopy(payload, 0, packet, HEAD_BYTES, payload.length);
    int crc = RoboClawRequest.crc(0, payload, 0, payload.length); // same CRC-16/XMODEM
    packet[packet.length - 3] = (byte) (crc >> 8);
    packet[packet.length - 2] = (byte) crc;
    packet[packet.length - 1] = END;
    return packet;
  }

  @Override
  protected int lengthAt(int at, int available) {
    if (unsigned8(at) != SHORT) {
      return NONE;
    }
    return available < HEAD_BYTES ? HEAD_BYTES : HEAD_BYTES + unsigned8(at + 1) + TAIL_BYTES;
  }

  @Override
  protected String fault(int at, int length) {
    int begin = at + HEAD_BYTES;
    int end = at + length - TAIL_BYTES;
    boolean isIntact =
        end > begin
            && unsigned8(end + 2) == END
            && RoboClawRequest.crc(0, bytes(), begin, end)
                == RoboClawRequest.unsigned16(bytes(), end);
    return isIntact ? "" : "a packet with a wrong checksum";
  }

  @Override
  protected void take(int at, int length) {
    sink.accept(Arrays.copyOfRange(bytes(), at + HEAD_BYTES, at + length - TAIL_BYTES));
  }
}
