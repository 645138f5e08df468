package org.u2sa.drivers.sonar;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.ObjIntConsumer;
import org.u2sa.drivers.link.BinaryFramer;

/**
 * Messages of the ping protocol: {@code BR}, payload length, message ID, sender, receiver, payload,
 * sum of all preceding bytes; little-endian (bluerobotics/ping-protocol, README).
 */
final class PingFramer extends BinaryFramer {
  private static final int HEAD_BYTES = 8;
  private static final int SUM_BYTES = 2;
  private static final int MAX_PAYLOAD = 4_096; // 1,200 samples of a Ping360 and its settings

  private final ObjIntConsumer<ByteBuffer> sink;

  /**
   * @param sink receives the little-endian payload and the ID of each message
   * @param refusals receives the reason of each rejection
   */
  PingFramer(ObjIntConsumer<ByteBuffer> sink, Consumer<String> refusals) {
    super(HEAD_BYTES + MAX_PAYLOAD + SUM_BYTES, refusals);
    this.sink = sink;
  }

  /** Encodes a message to any device. */
  static byte[] of(int id, byte... payload) {
    ByteBuffer message =
        ByteBuffer.allocate(HEAD_BYTES + payload.length + SUM_BYTES).order(ByteOrder.LITTLE_ENDIAN);
    message.put((byte) 'B').put((byte) 'R').putShort((short) payload.length).putShort((short) id);
    message.put((byte) 0).put((byte) 0).put(payload);
    return message.putShort((short) sum(message.array(), 0, message.position())).array();
  }

  @Override
  protected int lengthAt(int at, int available) {
    boolean canBegin =
        unsigned8(at) == 'B'
            && (available < 2 || unsigned8(at + 1) == 'R')
            && (available < HEAD_BYTES || unsigned16(at + 2) <= MAX_PAYLOAD);
    if (!canBegin) {
      return NONE;
    }
    return available < HEAD_BYTES ? HEAD_BYTES : HEAD_BYTES + unsigned16(at + 2) + SUM_BYTES;
  }

  @Override
  protected String fault(int at, int length) {
    int end = at + length - SUM_BYTES;
    return unsigned16(end) == (sum(bytes(), at, end) & 0xFFFF) ? "" : "wrong checksum";
  }

  @Override
  protected void take(int at, int length) {
    byte[] payload = Arrays.copyOfRange(bytes(), at + HEAD_BYTES, at + length - SUM_BYTES);
    sink.accept(ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN), unsigned16(at + 4));
  }

  private static int sum(byte[] message, int from, int to) {
    int sum = 0;
    for (int i = from; i < to; i++) {
      sum += message[i] & 0xFF;
    }
    return sum;
  }
}
