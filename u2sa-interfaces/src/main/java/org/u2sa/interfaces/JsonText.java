package org.u2sa.interfaces;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.PrettyPrinter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/** A JSON object with keys in insertion order; unknown values are omitted. */
public final class JsonText {
  private static final JsonFactory FACTORY = new JsonFactory();

  private final Map<String, Object> fields = new LinkedHashMap<>();

  /**
   * Adds a text, number, boolean, object, collection, or an Optional of these; empty Optionals are
   * omitted.
   */
  public JsonText put(String name, Object value) {
    Object known = value;
    if (value instanceof Optional<?> optional) {
      known = optional.orElse(null);
    } else if (value instanceof OptionalDouble number) {
      known = number.isPresent() ? number.getAsDouble() : null;
    } else if (value instanceof OptionalLong number) {
      known = number.isPresent() ? number.getAsLong() : null;
    }
    if (known != null) {
      fields.put(name, known);
    }
    return this;
  }

  /** Adds a field with the value {@code null}. */
  public JsonText putNull(String name) {
    fields.put(name, null);
    return this;
  }

  private static void write(JsonGenerator json, Object value) throws IOException {
    if (value instanceof JsonText object) {
      json.writeStartObject();
      for (Map.Entry<String, Object> field : object.fields.entrySet()) {
        json.writeFieldName(field.getKey());
        write(json, field.getValue());
      }
      json.writeEndObject();
    } else if (value instanceof Collection<?> list) {
      json.writeStartArray();
      for (Object element : list) {
        write(json, element);
      }
      json.writeEndArray();
    } else {
      json.writeObject(value);
    }
  }

  public String line() {
    return text(null);
  }

  @Override
  public String toString() {
    return text(new DefaultPrettyPrinter());
  }

  private String text(PrettyPrinter printer) {
    StringWriter text = new StringWriter();
    try (JsonGenerator json = FACTORY.createGenerator(text)) {
      json.setPrettyPrinter(printer);
      write(json, this);
    } catch (IOException e) {
      throw new UncheckedIOException("writing into memory", e);
    }
    return text.toString();
  }
}
