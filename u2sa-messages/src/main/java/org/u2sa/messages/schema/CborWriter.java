package org.u2sa.messages.schema;

import com.fasterxml.jackson.core.util.ByteArrayBuilder;
import com.fasterxml.jackson.dataformat.cbor.CBORFactory;
import com.fasterxml.jackson.dataformat.cbor.CBORGenerator;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.frame.Point;

/**
 * Writes one message as CBOR (RFC 8949): definite lengths, shortest integers, float64, fields in
 * the schema's order.
 */
final class CborWriter {
  private static final CBORFactory FACTORY = new CBORFactory();
  private static final int TYPICAL_BYTES = 512;

  private CborWriter() {}

  /** The message, and who sends it unless that is null. */
  static byte[] bytes(U2SAData message, Origin origin) {
    ByteArrayBuilder buffer = new ByteArrayBuilder(TYPICAL_BYTES);
    try (CBORGenerator generator = FACTORY.createGenerator(buffer)) {
      message(generator, message, origin, false);
    } catch (IOException e) {
      throw new UncheckedIOException("memory refused bytes", e);
    }
    byte[] bytes = buffer.toByteArray();
    if (bytes.length > Limits.PAYLOAD_BYTES) {
      throw new IllegalStateException(
          String.format(
              "%s: %s bytes exceed the %s that readers take",
              String.join("/", message.typeChain()), bytes.length, Limits.PAYLOAD_BYTES));
    }
    return bytes;
  }

  private static void message(CBORGenerator out, U2SAData message, Origin origin, boolean withType)
      throws IOException {
    List<MessageField<U2SAData>> fields = message.ownType().fields();
    Map<String, Object> unknown = message.unknownFields();
    int size = unknown.size() + (withType ? 1 : 0) + (origin == null ? 0 : 1);
    for (MessageField<U2SAData> field : fields) {
      if (field.isWritten(message)) {
        size++;
      }
    }
    out.writeStartObject(message, size);
    if (withType) {
      out.writeFieldName(Schema.TYPE_KEY);
      List<String> chain = message.typeChain();
      out.writeArray(chain.toArray(new String[0]), 0, chain.size());
    }
    for (MessageField<U2SAData> field : fields) {
      if (field.isWritten(message)) {
        out.writeFieldName(field.key);
        field.write(out, message);
      }
    }
    for (Map.Entry<String, Object> entry : unknown.entrySet()) {
      out.writeFieldName(entry.getKey());
      AnyValue.write(out, entry.getValue());
    }
    if (origin != null) {
      out.writeFieldName(Origin.KEY);
      out.writeStartArray(null, Origin.ELEMENTS);
      out.writeString(origin.sender());
      out.writeNumber(origin.sequence());
      out.writeEndArray();
    }
    out.writeEndObject();
  }

  static void nested(CBORGenerator out, U2SAData message) throws IOException {
    message(out, message, null, true);
  }

  static void point(CBORGenerator out, Point value) throws IOException {
    out.writeArray(new double[] {value.x(), value.y(), value.z()}, 0, 3);
  }
}
