package org.u2sa.gcs.configuration;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationVariable;

/** Configurations for programs. What is not known is left out. */
final class ConfigurationJson {
  private ConfigurationJson() {}

  /** Writes one value. */
  private interface Content {
    void write(JsonGenerator json) throws IOException;
  }

  static String text(String systemId, List<ConfigurationResponse> services) {
    return text(
        json -> {
          json.writeStartObject();
          json.writeStringField("system", systemId);
          json.writeArrayFieldStart("services");
          for (ConfigurationResponse service : services) {
            json.writeStartObject();
            json.writeStringField("name", service.serviceName());
            if (service.revision().isPresent()) {
              json.writeNumberField("revision", service.revision().getAsLong());
            }
            json.writeArrayFieldStart("variables");
            for (ConfigurationVariable variable : service.variables()) {
              write(json, variable);
            }
            json.writeEndArray();
            json.writeEndObject();
          }
          json.writeEndArray();
          json.writeEndObject();
        });
  }

  static String text(ConfigurationVariable variable) {
    return text(json -> write(json, variable));
  }

  static String text(ConfigurationTransactionResult result) {
    return text(
        json -> {
          json.writeStartObject();
          json.writeStringField("service", result.serviceName());
          json.writeNumberField("revision", result.revision());
          json.writeArrayFieldStart("changes");
          for (ConfigurationAssignment assignment : result.assignments()) {
            json.writeStartObject();
            json.writeStringField("variable", assignment.variableName());
            json.writeStringField("old", assignment.previous().orElse(""));
            json.writeStringField("new", assignment.value());
            json.writeEndObject();
          }
          json.writeEndArray();
          json.writeEndObject();
        });
  }

  private static void write(JsonGenerator json, ConfigurationVariable variable) throws IOException {
    json.writeStartObject();
    json.writeStringField("name", variable.name());
    json.writeStringField("type", variable.variableType());
    json.writeFieldName("value");
    switch (variable.variableType()) {
      case "double", "int" -> json.writeNumber(variable.value());
      case "boolean" -> json.writeBoolean(Boolean.parseBoolean(variable.value()));
      default -> json.writeString(variable.value());
    }
    if (!variable.unit().isEmpty()) {
      json.writeStringField("unit", variable.unit());
    }
    if (variable.min().isPresent()) {
      json.writeNumberField("min", variable.min().getAsDouble());
    }
    if (variable.max().isPresent()) {
      json.writeNumberField("max", variable.max().getAsDouble());
    }
    if (!variable.choices().isEmpty()) {
      json.writeArrayFieldStart("choices");
      for (String choice : variable.choices()) {
        json.writeString(choice);
      }
      json.writeEndArray();
    }
    json.writeStringField("description", variable.description());
    json.writeEndObject();
  }

  private static String text(Content content) {
    StringWriter text = new StringWriter();
    try (JsonGenerator json = new JsonFactory().createGenerator(text)) {
      json.setPrettyPrinter(new DefaultPrettyPrinter());
      content.write(json);
    } catch (IOException e) {
      throw new UncheckedIOException("writing into memory", e);
    }
    return text.toString();
  }
}
