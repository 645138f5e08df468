package org.u2sa.interfaces.configuration;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;

/** An {@link AuditEntry} as a line of JSON, for people and programs alike. */
final class AuditLine {
  private static final JsonFactory JSON = new JsonFactory();

  private AuditLine() {}

  /** The line, without its end. */
  static String of(AuditEntry entry) {
    StringWriter line = new StringWriter();
    try (JsonGenerator json = JSON.createGenerator(line)) {
      json.writeStartObject();
      json.writeNumberField("revision", entry.revision());
      json.writeStringField(
          "time", Instant.EPOCH.plus(entry.origin().micros(), ChronoUnit.MICROS).toString());
      json.writeStringField("service", entry.origin().service());
      json.writeStringField("author", entry.origin().author());
      json.writeStringField("outcome", entry.outcome().name());
      if (!entry.reason().isEmpty()) {
        json.writeStringField("reason", entry.reason());
      }
      if (entry.undoes().isPresent()) {
        json.writeNumberField("undoes", entry.undoes().getAsLong());
      }
      json.writeArrayFieldStart("changes");
      for (AuditEntry.Value value : entry.values()) {
        json.writeStartObject();
        json.writeStringField("variable", value.variable());
        write(json, "old", value.before());
        json.writeStringField("new", value.after());
        write(json, "oldText", value.textBefore());
        write(json, "newText", value.textAfter());
        json.writeEndObject();
      }
      json.writeEndArray();
      json.writeEndObject();
    } catch (IOException e) {
      throw new UncheckedIOException("a text cannot be written to", e);
    }
    return line.toString();
  }

  private static void write(JsonGenerator json, String field, Optional<String> text)
      throws IOException {
    if (text.isPresent()) {
      json.writeStringField(field, text.get());
    }
  }

  /** The entry; empty if the line is none: torn by a power cut, or written by hand. */
  static Optional<AuditEntry> read(String line) {
    try (JsonParser json = JSON.createParser(line)) {
      if (json.nextToken() != JsonToken.START_OBJECT) {
        return Optional.empty();
      }
      List<AuditEntry.Value> values = new ArrayList<>();
      Map<String, String> fields = fields(json, values);
      String undoes = fields.get("undoes");
      return Optional.of(
          new AuditEntry(
              Long.parseLong(required(fields, "revision")),
              new ChangeOrigin(
                  ChronoUnit.MICROS.between(Instant.EPOCH, Instant.parse(required(fields, "time"))),
                  fields.getOrDefault("service", ""),
                  fields.getOrDefault("author", "")),
              AuditEntry.Outcome.valueOf(required(fields, "outcome")),
              fields.getOrDefault("reason", ""),
              undoes == null ? OptionalLong.empty() : OptionalLong.of(Long.parseLong(undoes)),
              values));
    } catch (IOException | IllegalArgumentException | DateTimeException e) {
      return Optional.empty(); // what is no entry is passed over, as the log's users are told
    }
  }

  private static Map<String, String> fields(JsonParser json, List<AuditEntry.Value> values)
      throws IOException {
    Map<String, String> fields = new HashMap<>();
    while (json.nextToken() == JsonToken.FIELD_NAME) {
      String name = json.currentName();
      JsonToken token = json.nextToken();
      if (token == JsonToken.START_ARRAY && name.equals("changes")) {
        while (json.nextToken() == JsonToken.START_OBJECT) {
          values.add(value(fields(json, new ArrayList<>())));
        }
      } else {
        fields.put(name, json.getText());
        json.skipChildren();
      }
    }
    if (json.currentToken() != JsonToken.END_OBJECT) {
      throw new IllegalArgumentException("the line ends too early");
    }
    return fields;
  }

  private static AuditEntry.Value value(Map<String, String> fields) {
    return new AuditEntry.Value(
        required(fields, "variable"),
        Optional.ofNullable(fields.get("old")),
        required(fields, "new"),
        Optional.ofNullable(fields.get("oldText")),
        Optional.ofNullable(fields.get("newText")));
  }

  private static String required(Map<String, String> fields, String name) {
    String text = fields.get(name);
    if (text == null) {
      throw new IllegalArgumentException("\"" + name + "\" is missing");
    }
    return text;
  }
}
