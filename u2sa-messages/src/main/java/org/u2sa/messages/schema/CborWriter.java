package org.u2sa.messages.schema;

import java.util.List;
import java.util.Map;
import org.u2sa.messages.frame.Point;

/** Writes one message as CBOR: fields in the schema's order. */
final class CborWriter {
  private static final int COORDINATES = 3;
  private static final int ORIGIN_BYTES = 48; // with a sender of 32 characters

  private CborWriter() {}

  /** The message, and who sends it unless that is null. */
  static byte[] bytes(U2SAData message, Origin origin) {
    FieldTable.Written written = message.ownType().table().written(message);
    CborOutput out =
        new CborOutput(
            CborOutput.headBytes(written.fields())
                + written.bytes()
                + (origin == null ? 0 : ORIGIN_BYTES));
    message(out, message, written.fields(), origin, false);
    byte[] bytes = out.toBytes();
    if (bytes.length > Limits.PAYLOAD_BYTES) {
      throw new IllegalStateException(
          String.format(
              "%s: %s bytes exceed the %s that readers take",
              String.join("/", message.typeChain()), bytes.length, Limits.PAYLOAD_BYTES));
    }
    return bytes;
  }

  private static void message(
      CborOutput out, U2SAData message, int fields, Origin origin, boolean withType) {
    Map<String, Object> unknown = message.unknownFields();
    out.map(fields + unknown.size() + (withType ? 1 : 0) + (origin == null ? 0 : 1));
    if (withType) {
      out.item(Schema.TYPE_KEY_BYTES);
      List<String> chain = message.typeChain();
      out.array(chain.size());
      chain.forEach(out::text);
    }
    message.ownType().table().write(out, message);
    if (!unknown.isEmpty()) { // most have none, and need no iterator for it
      unknown.forEach(
          (name, value) -> {
            out.text(name);
            AnyValue.write(out, value);
          });
    }
    if (origin != null) {
      out.text(Origin.KEY);
      out.array(Origin.ELEMENTS);
      out.text(origin.sender());
      out.count(origin.sequence());
    }
  }

  static void nested(CborOutput out, U2SAData message) {
    message(out, message, message.ownType().table().written(message).fields(), null, true);
  }

  static void point(CborOutput out, Point value) {
    out.array(COORDINATES);
    out.number(value.x());
    out.number(value.y());
    out.number(value.z());
  }
}
