package org.u2sa.recorder;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.schema.Kind;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;

/**
 * The JSON Schema of a message's CBOR map, with units. The keyword {@code unit} is a U2SA
 * extension; JSON Schema readers ignore unknown keywords.
 */
public final class SchemaText {
  private static final String DIALECT = "https://json-schema.org/draft/2020-12/schema";

  private SchemaText() {}

  /** Schema of a type, on one line. */
  public static String of(MessageType<?> type) {
    JsonText properties = new JsonText();
    List<String> required = new ArrayList<>();
    addFields(type, properties, required);
    return new JsonText()
        .put("$schema", DIALECT)
        .put("title", type.name())
        .put("typeChain", type.chain())
        .put("type", "object")
        .put("properties", properties)
        .put("required", required)
        .line();
  }

  private static <T extends U2SAData> void addFields(
      MessageType<T> type, JsonText properties, List<String> required) {
    for (MessageField<T> field : type.fields()) {
      JsonText property = schema(field.kind());
      if (!field.unit().isEmpty()) {
        property.put("unit", field.unit());
      }
      properties.put(field.name(), property);
      if (field.isRequired()) {
        required.add(field.name());
      }
    }
  }

  private static JsonText schema(Kind kind) {
    return switch (kind) {
      case DOUBLE -> type("number");
      case LONG -> type("integer");
      case BOOLEAN -> type("boolean");
      case STRING, ENUM, FRAME -> type("string");
      case BYTES -> type("string").put("contentEncoding", "base64");
      case STRING_LIST -> listOf(type("string"));
      case DOUBLE_LIST, POINT -> listOf(type("number"));
      case BOOLEAN_LIST -> listOf(type("boolean"));
      case POINT_LIST -> listOf(listOf(type("number")));
      case MESSAGE_LIST -> listOf(type("object"));
    };
  }

  private static JsonText type(String name) {
    return new JsonText().put("type", name);
  }

  private static JsonText listOf(JsonText element) {
    return type("array").put("items", element);
  }
}
