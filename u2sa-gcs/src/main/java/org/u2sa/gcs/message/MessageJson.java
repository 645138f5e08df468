package org.u2sa.gcs.message;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.ByteString;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.messages.schema.U2SAData;

/**
 * A message's fields as JSON, shaped as its CBOR map is: numbers in the field's unit, enums by
 * name, points as arrays, bytes in base64, messages within with their {@code type}. Absent fields
 * are left out.
 */
public final class MessageJson {
  private MessageJson() {}

  /** The fields of a message that are set. */
  public static JsonText fields(U2SAData message) {
    JsonText json = new JsonText();
    for (FieldValue field : message.enumerateFields()) {
      field.value().ifPresent(value -> json.put(field.name(), plain(value)));
    }
    return json;
  }

  /** The units of the fields that are set and have one. */
  public static JsonText units(U2SAData message) {
    JsonText json = new JsonText();
    for (FieldValue field : message.enumerateFields()) {
      if (field.value().isPresent() && !field.unit().isEmpty()) {
        json.put(field.name(), field.unit());
      }
    }
    return json;
  }

  /** The name of the message's own type. */
  public static String typeName(U2SAData message) {
    List<String> chain = message.typeChain();
    return chain.get(chain.size() - 1);
  }

  /** A value of a field as {@link JsonText} takes it. */
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
    if (value instanceof Map<?, ?> map) { // of a field that is not known here
      JsonText json = new JsonText();
      map.forEach((key, inner) -> json.put(String.valueOf(key), plain(inner)));
      return json;
    }
    return value instanceof Number || value instanceof Boolean ? value : String.valueOf(value);
  }
}
