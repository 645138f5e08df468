package org.u2sa.cli.describe;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import org.u2sa.cli.describe.VehicleComposition.AnnouncedActuator;
import org.u2sa.cli.describe.VehicleComposition.ComposedService;
import org.u2sa.cli.describe.VehicleComposition.HeardSource;
import org.u2sa.core.launch.AutonomyLevels.Level;

/** Formats a vehicle's composition as JSON. Unknown values are omitted. */
final class DescriptionJson {
  private final JsonGenerator json;

  private DescriptionJson(JsonGenerator json) {
    this.json = json;
  }

  static String text(VehicleComposition vehicle) {
    StringWriter text = new StringWriter();
    try (JsonGenerator json = new JsonFactory().createGenerator(text)) {
      json.setPrettyPrinter(new DefaultPrettyPrinter());
      new DescriptionJson(json).write(vehicle);
    } catch (IOException e) {
      throw new UncheckedIOException("writing into memory", e);
    }
    return text.toString();
  }

  private void write(VehicleComposition vehicle) throws IOException {
    json.writeStartObject();
    json.writeStringField("system", vehicle.systemId());
    json.writeStringField("origin", vehicle.origin());
    json.writeBooleanField("live", vehicle.live());
    json.writeObjectFieldStart("autonomy");
    for (AutonomyEvidence.Finding finding : new AutonomyEvidence(vehicle).findings()) {
      json.writeObjectFieldStart(finding.dimension());
      if (finding.stated().isPresent()) {
        level("stated", finding.stated().get());
      }
      level("shown", finding.shown());
      json.writeStringField("because", finding.because());
      json.writeEndObject();
    }
    json.writeEndObject();
    json.writeArrayFieldStart("services");
    for (ComposedService service : vehicle.services()) {
      service(service, vehicle);
    }
    json.writeEndArray();
    if (vehicle.live()) {
      heard(vehicle);
    }
    actuators(vehicle);
    json.writeEndObject();
  }

  private void level(String field, Level level) throws IOException {
    json.writeObjectFieldStart(field);
    json.writeNumberField("level", level.number());
    json.writeStringField("name", level.words());
    json.writeEndObject();
  }

  private void service(ComposedService service, VehicleComposition vehicle) throws IOException {
    json.writeStartObject();
    json.writeStringField("name", service.name());
    text("role", service.role());
    text("className", service.className());
    text("configuration", service.configuration());
    if (!service.variables().isEmpty()) {
      texts("variables", service.variables());
    }
    if (!service.stated().isEmpty()) {
      texts("states", service.stated());
    }
    json.writeArrayFieldStart("subscribes");
    for (String channel : service.subscribes()) {
      channel(channel, "from", vehicle.publishersOf(channel));
    }
    json.writeEndArray();
    json.writeArrayFieldStart("publishes");
    for (String channel : service.publishes()) {
      channel(channel, "to", vehicle.subscribersOf(channel));
    }
    json.writeEndArray();
    text("note", service.note());
    json.writeEndObject();
  }

  private void channel(String channel, String direction, List<String> names) throws IOException {
    json.writeStartObject();
    json.writeStringField("channel", channel);
    names(direction, names);
    json.writeEndObject();
  }

  private void heard(VehicleComposition vehicle) throws IOException {
    json.writeArrayFieldStart("sources");
    for (HeardSource source : vehicle.sources()) {
      json.writeStartObject();
      json.writeStringField("channel", source.channel());
      text("sensor", source.sensor());
      json.writeStringField("type", source.type());
      json.writeNumberField("rateHz", source.rateHz());
      names("fields", source.fields());
      texts("sigmas", source.sigmas());
      json.writeEndObject();
    }
    json.writeEndArray();
  }

  private void actuators(VehicleComposition vehicle) throws IOException {
    json.writeArrayFieldStart("actuators");
    for (AnnouncedActuator actuator : vehicle.actuators()) {
      json.writeStartObject();
      json.writeStringField("name", actuator.name());
      texts("announces", actuator.facts());
      json.writeEndObject();
    }
    json.writeEndArray();
  }

  private void names(String field, List<String> names) throws IOException {
    json.writeArrayFieldStart(field);
    for (String name : names) {
      json.writeString(name);
    }
    json.writeEndArray();
  }

  private void texts(String field, Map<String, String> values) throws IOException {
    json.writeObjectFieldStart(field);
    for (Map.Entry<String, String> value : values.entrySet()) {
      json.writeStringField(value.getKey(), value.getValue());
    }
    json.writeEndObject();
  }

  private void text(String field, String value) throws IOException {
    if (!value.isEmpty()) {
      json.writeStringField(field, value);
    }
  }
}
