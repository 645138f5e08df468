package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.MavlinkDialect;
import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import io.dronefleet.mavlink.ardupilotmega.ArdupilotmegaDialect;
import io.dronefleet.mavlink.protocol.MavlinkPacket;
import io.dronefleet.mavlink.serialization.payload.reflection.ReflectionPayloadDeserializer;
import io.dronefleet.mavlink.serialization.payload.reflection.ReflectionPayloadSerializer;
import java.util.Arrays;
import java.util.function.Consumer;

/**
 * From bytes to messages of MAVLink 1 and 2 and back to MAVLink 2
 * (mavlink.io/en/guide/serialization): frames are found here, without waiting for bytes as the
 * library's reader does; checksums and payloads are the library's business. Signatures are passed
 * over.
 */
final class MavlinkStream {
  private static final int MAGIC_1 = 0xFE;
  private static final int MAGIC_2 = 0xFD;
  private static final int HEADER_1 = 6;
  private static final int HEADER_2 = 10;
  private static final int CHECKSUM = 2;
  private static final int SIGNATURE = 13;
  private static final int SIGNED = 0x01;

  private final MavlinkDialect dialect = new ArdupilotmegaDialect(); // has all common messages
  private final ReflectionPayloadDeserializer deserializer = new ReflectionPayloadDeserializer();
  private final ReflectionPayloadSerializer serializer = new ReflectionPayloadSerializer();
  private final int systemId;
  private final int componentId;
  private byte[] pending = new byte[0];
  private int sequence;
  private long malformed;

  /**
   * A message as it came.
   *
   * @param payload one of the library's message classes
   */
  record Received(int systemId, int componentId, Object payload) {}

  /** Speaks as that component of that system. */
  MavlinkStream(int systemId, int componentId) {
    this.systemId = systemId;
    this.componentId = componentId;
  }

  /** Forgets what was begun: the stream was cut. */
  void beginAnew() {
    pending = new byte[0];
  }

  /** Takes the next bytes of the stream and hands on what they complete. */
  void accept(byte[] bytes, int length, Consumer<Received> to) {
    int kept = pending.length;
    pending = Arrays.copyOf(pending, kept + length);
    System.arraycopy(bytes, 0, pending, kept, length);
    int from = 0;
    int used;
    while ((used = step(from, to)) > 0) {
      from += used;
    }
    pending = Arrays.copyOfRange(pending, from, pending.length);
  }

  /** Reads on from there; returns the bytes that are done with, 0 if more must come first. */
  private int step(int from, Consumer<Received> to) {
    int left = pending.length - from;
    if (left == 0) {
      return 0;
    }
    int magic = pending[from] & 0xFF;
    if (magic != MAGIC_1 && magic != MAGIC_2) {
      return 1;
    }
    int header = magic == MAGIC_2 ? HEADER_2 : HEADER_1;
    if (left < header) {
      return 0;
    }
    int flags = magic == MAGIC_2 ? pending[from + 2] & 0xFF : 0;
    if ((flags & ~SIGNED) != 0) {
      malformed++;
      return 1; // a reader must drop what it does not understand
    }
    int payload = pending[from + 1] & 0xFF;
    int whole = header + payload + CHECKSUM + (flags == SIGNED ? SIGNATURE : 0);
    if (left < whole) {
      return 0;
    }
    byte[] frame = Arrays.copyOfRange(pending, from, from + whole);
    return decode(frame, to) ? whole : 1;
  }

  /** Returns false if the bytes are no frame. */
  private boolean decode(byte[] frame, Consumer<Received> to) {
    MavlinkPacket packet =
        (frame[0] & 0xFF) == MAGIC_2
            ? MavlinkPacket.fromV2Bytes(frame)
            : MavlinkPacket.fromV1Bytes(frame);
    if (!dialect.supports(packet.getMessageId())) {
      return true; // its checksum cannot be known
    }
    Class<?> type = dialect.resolve(packet.getMessageId());
    if (!packet.validateCrc(type.getAnnotation(MavlinkMessageInfo.class).crc())) {
      malformed++;
      return false;
    }
    try {
      Object payload = deserializer.deserialize(packet.getPayload(), type);
      to.accept(new Received(packet.getSystemId(), packet.getComponentId(), payload));
    } catch (IllegalArgumentException | IllegalStateException | IndexOutOfBoundsException e) {
      malformed++; // the checksum is right, but the library cannot make a message of it
    }
    return true;
  }

  /** The bytes of a message, as MAVLink 2. */
  byte[] encode(Object message) {
    MavlinkMessageInfo info = message.getClass().getAnnotation(MavlinkMessageInfo.class);
    byte[] payload = serializer.serialize(message);
    int length = payload.length;
    while (length > 1 && payload[length - 1] == 0) {
      length--; // MAVLink 2 leaves out the zeros at the end
    }
    return MavlinkPacket.createUnsignedMavlink2Packet(
            sequence++ & 0xFF,
            systemId,
            componentId,
            info.id(),
            info.crc(),
            Arrays.copyOf(payload, length))
        .getRawBytes();
  }

  /** How often bytes looked like a frame and were none. */
  long malformed() {
    return malformed;
  }
}
