package org.u2sa.gcs.services;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.service.directory.DataOffer;
import org.u2sa.service.directory.KnownService;

/** The services of a system for programs. What is not known is left out. */
final class ServicesJson {
  private final JsonGenerator json;

  private ServicesJson(JsonGenerator json) {
    this.json = json;
  }

  static String text(String systemId, DirectoryObservation observation) {
    StringWriter text = new StringWriter();
    try (JsonGenerator json = new JsonFactory().createGenerator(text)) {
      json.setPrettyPrinter(new DefaultPrettyPrinter());
      json.writeStartObject();
      json.writeStringField("system", systemId);
      json.writeArrayFieldStart("services");
      for (ServiceRow row : observation.rows()) {
        new ServicesJson(json)
            .service(row, observation.directory().service(row.name()).orElse(null));
      }
      json.writeEndArray();
      json.writeEndObject();
    } catch (IOException e) {
      throw new UncheckedIOException("writing into memory", e);
    }
    return text.toString();
  }

  private void service(ServiceRow row, KnownService service) throws IOException {
    json.writeStartObject();
    json.writeStringField("name", row.name());
    json.writeStringField("status", row.status());
    if (row.discovery().isPresent()) {
      discovery(row.discovery().get());
    }
    if (service != null && service.isComplete()) {
      offers("publishes", service.publishes());
      offers("subscribes", service.subscribes());
    }
    if (row.health().isPresent()) {
      health(row.health().get());
    }
    if (row.condition().isPresent()) {
      condition(row.condition().get());
    }
    json.writeEndObject();
  }

  private void discovery(DiscoveryResponse response) throws IOException {
    json.writeStringField("type", response.serviceType());
    json.writeStringField("host", response.host());
    json.writeNumberField("uptimeS", response.uptime());
    json.writeStringField("version", response.version());
    if (response.className().isPresent()) {
      json.writeStringField("className", response.className().get());
    }
    if (response.instance().isPresent()) {
      json.writeStringField("instance", response.instance().get());
    }
  }

  private void offers(String field, List<DataOffer> offers) throws IOException {
    json.writeArrayFieldStart(field);
    for (DataOffer offer : offers) {
      json.writeStartObject();
      json.writeStringField("channel", offer.channel());
      json.writeArrayFieldStart("typeChain");
      for (String type : offer.typeChain()) {
        json.writeString(type);
      }
      json.writeEndArray();
      json.writeEndObject();
    }
    json.writeEndArray();
  }

  private void health(HealthReport report) throws IOException {
    json.writeObjectFieldStart("health");
    json.writeNumberField("inbox", report.inboxDepth());
    json.writeNumberField("dropped", report.dropped());
    number("replaced", report.replaced());
    json.writeNumberField("refused", report.refused());
    json.writeNumberField("overruns", report.overruns());
    json.writeNumberField("exceptions", report.exceptions());
    number("callbackP50S", report.callbackP50());
    number("callbackP99S", report.callbackP99());
    number("commandsObeyed", report.commandsObeyed());
    number("commandsRefused", report.commandsRefused());
    if (report.refusedSubscriptions().isPresent()) {
      json.writeStringField("refusedSubscriptions", report.refusedSubscriptions().get());
    }
    if (report.lastError().isPresent()) {
      json.writeStringField("lastError", report.lastError().get());
    }
    json.writeEndObject();
  }

  private void number(String field, OptionalDouble value) throws IOException {
    if (value.isPresent()) {
      json.writeNumberField(field, value.getAsDouble());
    }
  }

  private void number(String field, OptionalLong value) throws IOException {
    if (value.isPresent()) {
      json.writeNumberField(field, value.getAsLong());
    }
  }

  private void condition(ServiceCondition condition) throws IOException {
    json.writeObjectFieldStart("condition");
    json.writeStringField("condition", condition.condition().name());
    json.writeStringField("reason", condition.reason());
    json.writeStringField("action", condition.action());
    json.writeNumberField("restarts", condition.restarts());
    json.writeEndObject();
  }
}
