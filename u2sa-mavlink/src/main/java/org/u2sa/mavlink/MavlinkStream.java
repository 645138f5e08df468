package org.u2sa.mavlink;

import io.dronefleet.mavlink.MavlinkDialect;
import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import io.dronefleet.mavlink.ardupilotmega.ArdupilotmegaDialect;
import io.dronefleet.mavlink.protocol.MavlinkPacket;
import io.dronefleet.mavlink.serialization.payload.reflection.ReflectionPayloadDeserializer;
import io.dronefleet.mavlink.serialization.payload.reflection.ReflectionPayloadSerializer;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Decodes MAVLink 1 and 2 and encodes MAVLink 2 (mavlink.io/en/guide/serialization). Framing is
 * done here, because the library's reader blocks; checksums and payloads are left to the library.
 * Without {@link MavlinkSigning} signatures are ignored.
 */
public final class MavlinkStream {
  private static final int MAGIC_1 = 0xFE;
  private static final int MAGIC_2 = 0xFD;
  private static final int HEADER_1 = 6;
  private static final int HEADER_2 = 10;
  private static final int CHECKSUM = 2;
  private static final int SIGNATURE = 13;
  private static final int SIGNED = 0x01;

  private final MavlinkDialect dialect = new ArdupilotmegaDialect(); // includes all common messages
  private final ReflectionPayloadDeserializer deserializer = new ReflectionPayloadDeserializer();
  private final ReflectionPayloadSerializer serializer = new ReflectionPayloadSerializer();
  private final int systemId;
  private final int componentId;
  private final Optional<MavlinkSigning> signing;
  private byte[] pending = new byte[0];
  private int sequence;
  private long consumed;
  private long malformed;
  private String lastRefusal = "";

  /** Whether a packet may begin with this byte. */
  public static boolean isMagic(byte first) {
    int magic = first & 0xFF;
    return magic == MAGIC_1 || magic == MAGIC_2;
  }

  /**
   * A received message.
   *
   * @param payload instance of a library message class
   */
  public record Received(int systemId, int componentId, Object payload) {}

  /** Creates a stream that sends as this component and system. */
  public MavlinkStream(int systemId, int componentId) {
    this(systemId, componentId, Optional.empty());
  }

  /**
   * Creates a stream that sends as this component and system.
   *
   * @param signing if present, all packets are signed, and unsigned ones are refused
   */
  public MavlinkStream(int systemId, int componentId, Optional<MavlinkSigning> signing) {
    this.systemId = systemId;
    this.componentId = componentId;
    this.signing = signing;
  }

  /** Discards a partial frame after an interruption; returns its bytes. */
  public byte[] reset() {
    byte[] partial = pending;
    pending = new byte[0];
    return partial;
  }

  /** Whether a whole frame's signature would be accepted now, or none is needed. */
  public boolean isAdmissible(byte[] frame) {
    return signing.map(each -> each.isAdmissible(frame)).orElse(true);
  }

  /** Whether a partial frame waits for its rest. */
  public boolean isPartial() {
    return pending.length > 0;
  }

  /** Bytes consumed so far; unchanged while a partial frame waits for its rest. */
  public long consumed() {
    return consumed;
  }

  /**
   * Looks for a message within a partial frame, whose start was then noise. Call only if its rest
   * is overdue: a message may contain another.
   */
  public void resynchronize(Consumer<Received> to) {
    for (int from = 1; from < pending.length; from++) {
      int used = step(from, to);
      if (used > 1) {
        consume(from + used);
        accept(new byte[0], 0, to);
        return;
      }
    }
  }

  /**
   * Consumes bytes and delivers completed messages.
   *
   * @param to may throw IllegalArgumentException for a message with unusable values despite a
   *     correct checksum; it then counts as malformed
   */
  public void accept(byte[] bytes, int length, Consumer<Received> to) {
    int kept = pending.length;
    pending = Arrays.copyOf(pending, kept + length);
    System.arraycopy(bytes, 0, pending, kept, length);
    int from = 0;
    int used;
    while ((used = step(from, to)) > 0) {
      from += used;
    }
    consume(from);
  }

  private void consume(int length) {
    pending = Arrays.copyOfRange(pending, length, pending.length);
    consumed += length;
  }

  /** Parses at an index; returns the number of bytes consumed, 0 if more are needed. */
  private int step(int from, Consumer<Received> to) {
    int left = pending.length - from;
    if (left == 0) {
      return 0;
    }
    int whole = size(from);
    if (whole == 0) {
      return 1; // the frame must be dropped
    }
    if (left < whole) {
      return 0;
    }
    MavlinkPacket packet = packet(from, whole);
    if (!dialect.supports(packet.getMessageId())) {
      return passOver(from, whole);
    }
    return decode(packet, to) ? whole : 1;
  }

  /** Bytes of the frame that begins at an index, as far as known; 0 if none begins. */
  private int size(int from) {
    int magic = pending[from] & 0xFF;
    if (!isMagic((byte) magic)) {
      return 0;
    }
    int header = magic == MAGIC_2 ? HEADER_2 : HEADER_1;
    if (pending.length - from < header) {
      return header;
    }
    int flags = magic == MAGIC_2 ? pending[from + 2] & 0xFF : 0;
    if ((flags & ~SIGNED) != 0) {
      return 0;
    }
    int payload = pending[from + 1] & 0xFF;
    return header + payload + CHECKSUM + (flags == SIGNED ? SIGNATURE : 0);
  }

  private MavlinkPacket packet(int from, int whole) {
    byte[] frame = Arrays.copyOfRange(pending, from, from + whole);
    return (frame[0] & 0xFF) == MAGIC_2
        ? MavlinkPacket.fromV2Bytes(frame)
        : MavlinkPacket.fromV1Bytes(frame);
  }

  /**
   * Passes over an unknown message, whose checksum cannot be verified. It was noise, and only its
   * first byte is consumed, if no frame follows it, or if it contains a valid one.
   */
  private int passOver(int from, int whole) {
    if (pending.length == from + whole) {
      return 0; // the next byte tells
    }
    boolean isFollowed = isMagic(pending[from + whole]);
    return isFollowed && !containsMessage(from + 1, from + whole) ? whole : 1;
  }

  private boolean containsMessage(int from, int until) {
    for (int at = from; at < until; at++) {
      int whole = size(at);
      if (whole > 0 && at + whole <= pending.length && isValid(packet(at, whole))) {
        return true;
      }
    }
    return false;
  }

  private boolean isValid(MavlinkPacket packet) {
    if (!dialect.supports(packet.getMessageId())) {
      return false;
    }
    Class<?> type = dialect.resolve(packet.getMessageId());
    return packet.validateCrc(type.getAnnotation(MavlinkMessageInfo.class).crc());
  }

  /** Delivers a known message; returns false if the bytes are not a frame. */
  private boolean decode(MavlinkPacket packet, Consumer<Received> to) {
    Class<?> type = dialect.resolve(packet.getMessageId());
    if (!isValid(packet)) {
      refuse(type.getSimpleName() + ": wrong checksum");
      return false;
    }
    String refusal = signing.map(each -> each.refusal(packet.getRawBytes())).orElse("");
    if (!refusal.isEmpty()) {
      refuse(type.getSimpleName() + ": " + refusal);
      return true;
    }
    try {
      Object payload = deserializer.deserialize(packet.getPayload(), type);
      to.accept(new Received(packet.getSystemId(), packet.getComponentId(), payload));
    } catch (IllegalArgumentException | IllegalStateException | IndexOutOfBoundsException e) {
      refuse(type.getSimpleName() + ": " + e.getMessage());
    }
    return true;
  }

  private void refuse(String why) {
    malformed++;
    lastRefusal = why;
  }

  /** Encodes a message as MAVLink 2. */
  public byte[] encode(Object message) {
    MavlinkMessageInfo info = message.getClass().getAnnotation(MavlinkMessageInfo.class);
    byte[] payload = serializer.serialize(message);
    int length = payload.length;
    while (length > 1 && payload[length - 1] == 0) {
      length--; // MAVLink 2 truncates trailing zeros
    }
    byte[] kept = Arrays.copyOf(payload, length);
    int number = sequence++ & 0xFF;
    if (signing.isPresent()) {
      return signing.get().sign(number, systemId, componentId, info.id(), info.crc(), kept);
    }
    return MavlinkPacket.createUnsignedMavlink2Packet(
            number, systemId, componentId, info.id(), info.crc(), kept)
        .getRawBytes();
  }

  /** Number of frames with a wrong checksum or signature, or whose message cannot be used. */
  public long malformed() {
    return malformed;
  }

  /** Reason of the last one; empty if none. */
  public String lastRefusal() {
    return lastRefusal;
  }
}
