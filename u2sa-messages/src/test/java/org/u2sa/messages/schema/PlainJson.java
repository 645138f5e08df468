package org.u2sa.messages.schema;

import java.util.List;
import java.util.Map;
import java.util.StringJoiner;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.frame.Point;

/**
 * Messages as JSON straight from their fields, not by way of CBOR, so that the golden vectors' two
 * files check each other.
 */
final class PlainJson {
  private static final String INDENT = "  ";

  private PlainJson() {}

  static String of(U2SAData message) {
    return "{\n"
        + INDENT
        + "\"typeChain\": "
        + value(message.typeChain(), INDENT)
        + ",\n"
        + INDENT
        + "\"presenceVector\": "
        + message.presenceVector()
        + ",\n"
        + INDENT
        + "\"message\": "
        + fields(message, INDENT, false)
        + "\n}\n";
  }

  private static String fields(U2SAData message, String indent, boolean withType) {
    String deeper = indent + INDENT;
    StringJoiner parts = new StringJoiner(",\n" + deeper, "{\n" + deeper, "\n" + indent + "}");
    parts.setEmptyValue("{}");
    if (withType) {
      parts.add("\"type\": " + value(message.typeChain(), deeper));
    }
    for (FieldValue field : message.enumerateFields()) {
      field.value().ifPresent(v -> parts.add(quoted(field.name()) + ": " + value(v, deeper)));
    }
    return parts.toString();
  }

  private static String value(Object value, String indent) {
    if (value instanceof Number || value instanceof Boolean) {
      return value.toString();
    }
    if (value instanceof ByteString bytes) {
      return quoted(bytes.toBase64());
    }
    if (value instanceof Point point) {
      return value(List.of(point.x(), point.y(), point.z()), indent);
    }
    if (value instanceof U2SAData message) {
      return fields(message, indent, true);
    }
    if (value instanceof List<?> list) {
      StringJoiner parts = new StringJoiner(", ", "[", "]");
      list.forEach(element -> parts.add(value(element, indent)));
      return parts.toString();
    }
    if (value instanceof Map<?, ?>) {
      throw new IllegalArgumentException("no message of these has a map: " + value);
    }
    return quoted(value.toString());
  }

  private static String quoted(String text) {
    return "\"" + text.replace("\\", "\\\\").replace("\"", "\\\"") + "\"";
  }
}
