package org.u2sa.report.message;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.messages.schema.U2SAData;

/**
 * Formats a message's fields as JSON, structured like its CBOR map: numbers in the field's unit,
 * enums by name, points as arrays, bytes in base64, nested messages with their {@code type}. Absent
 * fields are omitted.
 */
public final class MessageJson {
  private MessageJson() {}

  /** Set fields of a message. */
  public static JsonText fields(U2SAData message) {
    JsonText json = new JsonText();
    for (FieldValue field : message.enumerateFields()) {
      field.value().ifPresent(value -> json.put(field.name(), plain(value)));
    }
    return json;
  }

  /** Units of the set fields that have one. */
  public static JsonText units(U2SAData message) {
    JsonText json = new JsonText();
    for (FieldValue field : message.enumerateFields()) {
      if (field.value().isPresent() && !field.unit().isEmpty()) {
        json.put(field.name(), field.unit());
      }
    }
    return json;
  }

  /** Name of the message's own type. */
  public static String typeName(U2SAData message) {
    List<String> chain = message.typeChain();
    return chain.get(chain.size() - 1);
  }

  /** Value of a field for {@link JsonText}. */
  public static Object plain(Object value) {
    if (value instanceof U2SAData message) {
      JsonText json = new JsonText().put("type", typeName(message));
      for (FieldValue field : message.enumerateFields()) {
        field.value().ifPresent(inner -> json.put(field.name(), plain(inner)));
      }
      return json;
    }
    if (value instanceof ByteString bytes) {
      return bytes.toBase64();
    }
    if (value instanceof Point point) {
      return List.of(point.x(), point.y(), point.z());
    }
    if (value instanceof List<?> list) {
      List<Object> plain = new ArrayList<>();
      list.forEach(element -> plain.add(plain(element)));
      return plain;
    }
    if (value instanceof Map<?, ?> map) { // of an unknown field
      JsonText json = new JsonText();
      map.forEach((key, inner) -> json.put(String.valueOf(key), plain(inner)));
      return json;
    }
    return value instanceof Number || value instanceof Boolean ? value : String.valueOf(value);
  }
}
