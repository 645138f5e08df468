package org.u2sa.recorder.foxglove;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;

/**
 * Encodes a protobuf message field by field. Default values are omitted. Source:
 * protobuf.dev/programming-guides/encoding.
 */
final class ProtobufMessage {
  private static final int VARINT = 0;
  private static final int FIXED_64 = 1;
  private static final int LENGTH_DELIMITED = 2;
  private static final int FIXED_32 = 5;
  private static final int TYPE_BITS = 3;
  private static final int SEVEN_BITS = 0x7F;
  private static final int MORE = 0x80;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();

  ProtobufMessage number(int field, double value) {
    if (value != 0.0) {
      tag(field, FIXED_64);
      fixed64(value);
    }
    return this;
  }

  /** Packed repeated numbers, as in proto3. */
  ProtobufMessage numbers(int field, double[] values) {
    if (values.length > 0) {
      tag(field, LENGTH_DELIMITED);
      varint((long) values.length * Double.BYTES);
      for (double value : values) {
        fixed64(value);
      }
    }
    return this;
  }

  /** An integer, enum constant or boolean. */
  ProtobufMessage whole(int field, long value) {
    if (value != 0) {
      tag(field, VARINT);
      varint(value);
    }
    return this;
  }

  ProtobufMessage fixed32(int field, int value) {
    if (value != 0) {
      tag(field, FIXED_32);
      byte[] four =
          ByteBuffer.allocate(Integer.BYTES).order(ByteOrder.LITTLE_ENDIAN).putInt(value).array();
      out.write(four, 0, four.length);
    }
    return this;
  }

  ProtobufMessage text(int field, String value) {
    return value.isEmpty() ? this : data(field, value.getBytes(StandardCharsets.UTF_8));
  }

  ProtobufMessage data(int field, byte[] value) {
    tag(field, LENGTH_DELIMITED);
    varint(value.length);
    out.write(value, 0, value.length);
    return this;
  }

  /** A nested message; written even if empty, since its presence is significant. */
  ProtobufMessage message(int field, ProtobufMessage value) {
    return data(field, value.bytes());
  }

  /** A {@code google.protobuf.Timestamp}. */
  ProtobufMessage time(int field, long nanos) {
    long second = TimeUnit.SECONDS.toNanos(1);
    return message(
        field,
        new ProtobufMessage()
            .whole(1, Math.floorDiv(nanos, second))
            .whole(2, Math.floorMod(nanos, second)));
  }

  byte[] bytes() {
    return out.toByteArray();
  }

  private void tag(int field, int type) {
    varint((long) field << TYPE_BITS | type);
  }

  private void varint(long value) {
    long rest = value;
    while ((rest & ~SEVEN_BITS) != 0) {
      out.write((int) (rest & SEVEN_BITS) | MORE);
      rest >>>= 7;
    }
    out.write((int) rest);
  }

  private void fixed64(double value) {
    byte[] eight =
        ByteBuffer.allocate(Double.BYTES).order(ByteOrder.LITTLE_ENDIAN).putDouble(value).array();
    out.write(eight, 0, eight.length);
  }
}
