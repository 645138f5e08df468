package org.u2sa.core.communication.routing;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.ByteBufAllocator;
import io.netty.buffer.ByteBufUtil;
import io.netty.buffer.Unpooled;

/**
 * A message sent to several clients as MQTT packets. Common parts are encoded once, and long
 * payloads are not copied. Not thread-safe.
 */
public final class Publication {
  private static final int PUBLISH = 0x30;
  private static final int AT_LEAST_ONCE = 0x02;
  private static final int RETAIN = 0x01;
  private static final int LENGTH_BITS = 7; // of each byte of a packet's length
  private static final int MORE = 0x80;
  private static final int LONGEST_HEADER = 9; // type, length, topic length, packet ID
  private static final int COPIED_AT_MOST = 4_096; // cheaper than sending another buffer

  private final TopicRoute route;
  private final ByteBuf payload;
  private final boolean isRetained;
  private ByteBuf unconfirmed; // null until needed
  private ByteBuf copy; // of the payload; likewise; on the heap

  /**
   * @param payload remains owned by the caller
   * @param isRetained whether it was retained before the receiver subscribed
   */
  public Publication(TopicRoute route, ByteBuf payload, boolean isRetained) {
    this.route = route;
    this.payload = payload;
    this.isRetained = isRetained;
  }

  /** Whether it was retained before the receiver subscribed. */
  public boolean isRetained() {
    return isRetained;
  }

  /** Topic of the message. */
  public String topic() {
    return route.name();
  }

  /** QoS 0 packet; to be released by the caller. */
  public ByteBuf packet(ByteBufAllocator memory) {
    if (unconfirmed == null) {
      unconfirmed = composed(memory, 0);
    }
    return unconfirmed.retainedDuplicate();
  }

  /**
   * QoS 1 packet; to be released by the caller.
   *
   * @param packetId 1…65535
   */
  public ByteBuf packet(ByteBufAllocator memory, int packetId) {
    return composed(memory, packetId);
  }

  private ByteBuf composed(ByteBufAllocator memory, int packetId) {
    byte[] topic = route.utf8();
    int bytes = payload.readableBytes();
    boolean isCopied = bytes <= COPIED_AT_MOST;
    ByteBuf packet = memory.ioBuffer(LONGEST_HEADER + topic.length + (isCopied ? bytes : 0));
    packet.writeByte(PUBLISH | (packetId == 0 ? 0 : AT_LEAST_ONCE) | (isRetained ? RETAIN : 0));
    int left = Short.BYTES + topic.length + (packetId == 0 ? 0 : Short.BYTES) + bytes;
    for (; left >= MORE; left >>>= LENGTH_BITS) {
      packet.writeByte(left % MORE | MORE);
    }
    packet.writeByte(left);
    packet.writeShort(topic.length);
    packet.writeBytes(topic);
    if (packetId != 0) {
      packet.writeShort(packetId);
    }
    return isCopied
        ? packet.writeBytes(payload, payload.readerIndex(), bytes)
        : Unpooled.wrappedBuffer(packet, payload.retainedDuplicate());
  }

  /** Bytes of the payload. */
  public int length() {
    return payload.readableBytes();
  }

  /** The same message, which outlasts the payload; to be released by the caller. */
  public Publication lasting() {
    if (copy == null) {
      copy = Unpooled.wrappedBuffer(ByteBufUtil.getBytes(payload));
    }
    return new Publication(route, copy, isRetained);
  }

  /** Releases the shared buffers. */
  public void release() {
    if (unconfirmed != null) {
      unconfirmed.release();
    }
  }
}
