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

  private final CBORGenerator out;

  private CborWriter(CBORGenerator out) {
    this.out = out;
  }

  /** The message, and who sends it unless that is null. */
  static byte[] bytes(U2SAData message, Origin origin) {
    ByteArrayBuilder buffer = new ByteArrayBuilder(TYPICAL_BYTES);
    try (CBORGenerator generator = FACTORY.createGenerator(buffer)) {
      new CborWriter(generator).message(message, origin, false);
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

  private void message(U2SAData message, Origin origin, boolean withType) throws IOException {
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
      beginList(chain.size());
      for (String name : chain) {
        out.writeString(name);
      }
      endList();
    }
    for (MessageField<U2SAData> field : fields) {
      if (field.isWritten(message)) {
        out.writeFieldName(field.key);
        field.write(this, message);
      }
    }
    for (Map.Entry<String, Object> entry : unknown.entrySet()) {
      out.writeFieldName(entry.getKey());
      AnyValue.write(this, entry.getValue());
    }
    if (origin != null) {
      out.writeFieldName(Origin.KEY);
      beginList(Origin.ELEMENTS);
      out.writeString(origin.sender());
      out.writeNumber(origin.sequence());
      endList();
    }
    out.writeEndObject();
  }

  void nested(U2SAData message) throws IOException {
    message(message, null, true);
  }

  void number(double value) throws IOException {
    out.writeNumber(value);
  }

  void count(long value) throws IOException {
    out.writeNumber(value);
  }

  void flag(boolean value) throws IOException {
    out.writeBoolean(value);
  }

  void text(String value) throws IOException {
    out.writeString(value);
  }

  void point(Point value) throws IOException {
    beginList(3);
    out.writeNumber(value.x());
    out.writeNumber(value.y());
    out.writeNumber(value.z());
    endList();
  }

  void beginList(int size) throws IOException {
    out.writeStartArray(null, size);
  }

  void endList() throws IOException {
    out.writeEndArray();
  }

  void beginMap(int size) throws IOException {
    out.writeStartObject(null, size);
  }

  void key(String name) throws IOException {
    out.writeFieldName(name);
  }

  void endMap() throws IOException {
    out.writeEndObject();
  }
}
