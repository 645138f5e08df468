package org.u2sa.recorder.foxglove;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A protobuf message taken apart by the encoding's own rules, without its schema. */
final class ProtobufFields {
  private final Map<Integer, List<Object>> fields = new LinkedHashMap<>();

  ProtobufFields(byte[] message) {
    ByteBuffer in = ByteBuffer.wrap(message).order(ByteOrder.LITTLE_ENDIAN);
    while (in.hasRemaining()) {
      int tag = (int) varint(in);
      Object value =
          switch (tag & 7) {
            case 0 -> varint(in);
            case 1 -> in.getDouble();
            case 2 -> bytes(in);
            case 5 -> in.getInt();
            default -> throw new IllegalArgumentException("wire type " + (tag & 7));
          };
      fields.computeIfAbsent(tag >>> 3, field -> new ArrayList<>()).add(value);
    }
  }

  private static long varint(ByteBuffer in) {
    long value = 0;
    for (int shift = 0; ; shift += 7) {
      byte next = in.get();
      value |= (long) (next & 0x7F) << shift;
      if (next >= 0) {
        return value;
      }
    }
  }

  private static byte[] bytes(ByteBuffer in) {
    byte[] value = new byte[(int) varint(in)];
    in.get(value);
    return value;
  }

  double number(int field) {
    return fields.containsKey(field) ? (double) fields.get(field).get(0) : 0.0;
  }

  long whole(int field) {
    return fields.containsKey(field) ? ((Number) fields.get(field).get(0)).longValue() : 0;
  }

  String text(int field) {
    return new String(data(field), StandardCharsets.UTF_8);
  }

  byte[] data(int field) {
    return (byte[]) fields.get(field).get(0);
  }

  ProtobufFields message(int field) {
    return new ProtobufFields(data(field));
  }

  List<ProtobufFields> messages(int field) {
    return fields.getOrDefault(field, List.of()).stream()
        .map(value -> new ProtobufFields((byte[]) value))
        .toList();
  }

  double[] numbers(int field) {
    ByteBuffer packed = ByteBuffer.wrap(data(field)).order(ByteOrder.LITTLE_ENDIAN);
    double[] values = new double[packed.remaining() / Double.BYTES];
    packed.asDoubleBuffer().get(values);
    return values;
  }
}
