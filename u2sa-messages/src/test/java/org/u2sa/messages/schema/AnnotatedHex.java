package org.u2sa.messages.schema;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.nio.ByteBuffer;

/**
 * A flat CBOR map as hexadecimal with notes, by its own small reader of RFC 8949 and not by the
 * codec's.
 */
final class AnnotatedHex {
  private final ByteBuffer in;
  private final StringBuilder out = new StringBuilder();

  private AnnotatedHex(byte[] bytes) {
    in = ByteBuffer.wrap(bytes);
  }

  static String of(byte[] bytes) {
    AnnotatedHex hex = new AnnotatedHex(bytes);
    hex.out.append("```\n");
    int pairs = hex.in.get() & 0x1f;
    hex.line(0, "map of " + pairs + " pairs");
    for (int i = 0; i < 2 * pairs; i++) {
      hex.item();
    }
    return hex.out.append("```\n").toString();
  }

  private void item() {
    int start = in.position();
    int head = in.get() & 0xff;
    int detail = head & 0x1f;
    switch (head >> 5) {
      case 0:
        long count = detail < 24 ? detail : detail == 27 ? in.getLong() : in.getInt();
        line(start, "int " + count);
        break;
      case 3:
        byte[] text = new byte[detail];
        in.get(text);
        line(start, "text of " + detail + " bytes: \"" + new String(text, UTF_8) + "\"");
        break;
      case 7:
        line(start, "float64 " + in.getDouble());
        break;
      default:
        throw new IllegalArgumentException("no flat map: head " + head + " at byte " + start);
    }
  }

  private void line(int start, String note) {
    StringBuilder hex = new StringBuilder();
    for (int i = start; i < in.position(); i++) {
      hex.append(String.format("%02x ", in.get(i)));
    }
    out.append(String.format("%02x  %-42s %s%n", start, hex, note));
  }
}
