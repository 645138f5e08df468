package org.u2sa.messages.schema;

import java.util.List;
import java.util.Map;
import org.u2sa.messages.frame.Point;

/** Writes one message as CBOR: fields in the schema's order. */
final class CborWriter {
  private static final int COORDINATES = 3;
  private static final int BYTES_BESIDE = 64; // who sends it, a longer text
  private static final int BYTES_A_FIELD = 24; // with its name

  private CborWriter() {}

  /** The message, and who sends it unless that is null. */
  static byte[] bytes(U2SAData message, Origin origin) {
    CborOutput out = new CborOutput(expectedBytes(message));
    message(out, message, origin, false);
    byte[] bytes = out.toBytes();
    if (bytes.length > Limits.PAYLOAD_BYTES) {
      throw new IllegalStateException(
          String.format(
              "%s: %s bytes exceed the %s that readers take",
              String.join("/", message.typeChain()), bytes.length, Limits.PAYLOAD_BYTES));
    }
    return bytes;
  }

  /** Not too few for most messages; lists take what they need. */
  private static int expectedBytes(U2SAData message) {
    return BYTES_BESIDE + BYTES_A_FIELD * message.ownType().written(message);
  }

  private static void message(CborOutput out, U2SAData message, Origin origin, boolean withType) {
    MessageType<U2SAData> type = message.ownType();
    Map<String, Object> unknown = message.unknownFields();
    int written = type.written(message);
    out.map(written + unknown.size() + (withType ? 1 : 0) + (origin == null ? 0 : 1));
    if (withType) {
      out.item(Schema.TYPE_KEY_BYTES);
      List<String> chain = message.typeChain();
      out.array(chain.size());
      chain.forEach(out::text);
    }
    type.write(out, message);
    unknown.forEach(
        (name, value) -> {
          out.text(name);
          AnyValue.write(out, value);
        });
    if (origin != null) {
      out.text(Origin.KEY);
      out.array(Origin.ELEMENTS);
      out.text(origin.sender());
      out.count(origin.sequence());
    }
  }

  static void nested(CborOutput out, U2SAData message) {
    message(out, message, null, true);
  }

  static void point(CborOutput out, Point value) {
    out.array(COORDINATES);
    out.number(value.x());
    out.number(value.y());
    out.number(value.z());
  }
}
