package org.u2sa.messages.schema;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.FieldKey;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.WireForm;

/** Writes one message as CBOR: fields in the schema's order. */
final class CborWriter {
  private static final FieldKey[] TYPE_KEYS = keys(FieldTable.TYPE_KEY); // by form
  private static final FieldKey[] ORIGIN_KEYS = keys(Origin.KEY);

  private CborWriter() {}

  private static FieldKey[] keys(String name) {
    return Stream.of(WireForm.values()).map(form -> form.key(name)).toArray(FieldKey[]::new);
  }

  /**
   * Writes a complete message, and its sender unless null.
   *
   * @param table fields of the message's type with keys of that form
   */
  static <M extends StoredMessage> byte[] bytes(
      M message, FieldTable<M> table, Origin origin, WireForm form) {
    CborOutput out = new CborOutput(form, table.typicalBytes());
    message(out, message, table, origin, false);
    byte[] bytes = out.toBytes();
    table.typicalBytes(bytes.length);
    if (bytes.length > Limits.PAYLOAD_BYTES) {
      throw new IllegalStateException(
          String.format(
              "%s: %s bytes exceed the %s that readers accept",
              String.join("/", message.typeChain()), bytes.length, Limits.PAYLOAD_BYTES));
    }
    return bytes;
  }

  static <M extends StoredMessage> void nested(CborOutput out, M message, FieldTable<M> table) {
    message(out, message, table, null, true);
  }

  private static <M extends StoredMessage> void message(
      CborOutput out, M message, FieldTable<M> table, Origin origin, boolean withType) {
    WireForm form = out.form();
    Map<String, Object> unknown = message.unknownFields();
    out.map(table.count(message) + unknown.size() + (withType ? 1 : 0) + (origin == null ? 0 : 1));
    if (withType) {
      out.key(TYPE_KEYS[form.ordinal()]);
      List<String> chain = message.typeChain();
      out.array(chain.size());
      chain.forEach(out::text);
    }
    table.write(out, message);
    if (!unknown.isEmpty()) { // avoids an iterator in the common case
      unknown.forEach(
          (name, value) -> {
            out.key(form.key(name));
            AnyValue.write(out, value);
          });
    }
    if (origin != null) {
      out.key(ORIGIN_KEYS[form.ordinal()]);
      out.array(Origin.ELEMENTS);
      out.text(origin.sender());
      out.count(origin.sequence());
    }
  }
}
