package org.u2sa.report.message;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.messages.schema.U2SAData;

/**
 * Formats messages and schemas for Foxglove and Lichtblick. Their JSON Schema parser rejects lists
 * of lists, so points in lists are objects with x, y and z; all else is as in {@link MessageJson}.
 */
public final class ViewerJson {
  private static final List<String> POINT = List.of("x", "y", "z");

  private ViewerJson() {}

  public static JsonText fields(U2SAData message) {
    JsonText json = new JsonText();
    for (FieldValue field : message.enumerateFields()) {
      field.value().ifPresent(value -> json.put(field.name(), value(MessageJson.plain(value))));
    }
    return json;
  }

  private static Object value(Object plain) {
    if (!(plain instanceof List<?> list)) {
      return plain;
    }
    List<Object> elements = new ArrayList<>();
    list.forEach(
        element -> elements.add(element instanceof List<?> point ? named(point) : element));
    return elements;
  }

  private static JsonText named(List<?> point) {
    JsonText json = new JsonText();
    for (int i = 0; i < point.size(); i++) {
      json.put(i < POINT.size() ? POINT.get(i) : Integer.toString(i), point.get(i));
    }
    return json;
  }

  /**
   * Schema of the output of {@link #fields}.
   *
   * @param origin owner of the schema, for errors
   * @param recorded JSON Schema of the message's CBOR map
   * @throws org.u2sa.interfaces.BadInputException if that is not a JSON object
   */
  public static String schema(String origin, String recorded) {
    Map<String, Object> schema = JsonReader.object(origin, recorded);
    if (schema.get("properties") instanceof Map<?, ?> properties) {
      Map<String, Object> changed = new LinkedHashMap<>();
      properties.forEach((name, property) -> changed.put((String) name, property(property)));
      schema.put("properties", changed);
    }
    return ((JsonText) MessageJson.plain(schema)).line();
  }

  private static Object property(Object property) {
    if (!(property instanceof Map<?, ?> map) || !isList(map) || !isList(map.get("items"))) {
      return property;
    }
    Map<String, Object> coordinates = new LinkedHashMap<>();
    POINT.forEach(name -> coordinates.put(name, Map.of("type", "number")));
    Map<String, Object> point = new LinkedHashMap<>(); // ordered: schema text is reproducible
    point.put("type", "object");
    point.put("properties", coordinates);
    Map<Object, Object> changed = new LinkedHashMap<>(map);
    changed.put("items", point);
    return changed;
  }

  private static boolean isList(Object schema) {
    return schema instanceof Map<?, ?> map && "array".equals(map.get("type"));
  }
}
