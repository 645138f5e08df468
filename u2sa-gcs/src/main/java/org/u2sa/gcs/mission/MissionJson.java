package org.u2sa.gcs.mission;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.contract.MissionReport;

/** Formats a mission as JSON. Unknown values are omitted. */
public final class MissionJson {
  private final JsonGenerator json;
  private final MissionView mission;

  private MissionJson(JsonGenerator json, MissionView mission) {
    this.json = json;
    this.mission = mission;
  }

  public static String text(String systemId, MissionView mission) {
    StringWriter text = new StringWriter();
    try (JsonGenerator json = new JsonFactory().createGenerator(text)) {
      json.setPrettyPrinter(new DefaultPrettyPrinter());
      new MissionJson(json, mission).write(systemId);
    } catch (IOException e) {
      throw new UncheckedIOException("writing into memory", e);
    }
    return text.toString();
  }

  private void write(String systemId) throws IOException {
    MissionReport report = mission.report();
    json.writeStartObject();
    json.writeStringField("system", systemId);
    json.writeStringField("mission", report.mission());
    json.writeBooleanField("over", report.current().isEmpty());
    json.writeBooleanField("paused", report.paused());
    json.writeNumberField("elapsedS", report.elapsed());
    number("timeLimitS", report.timeLimit());
    names("current", report.current());
    names("upcoming", report.upcoming());
    if (report.failsafe().isPresent()) {
      json.writeStringField("failsafe", report.failsafe().get());
    }
    if (report.resumable().isPresent()) {
      json.writeStringField("resumable", report.resumable().get());
    }
    json.writeArrayFieldStart("goals");
    for (int i = 0; i < report.goals().size(); i++) {
      goal(report.goals().get(i), mission.timesFinished(i));
    }
    json.writeEndArray();
    json.writeEndObject();
  }

  private void goal(GoalInformation goal, long times) throws IOException {
    json.writeStartObject();
    json.writeStringField("name", goal.uid());
    json.writeStringField("class", goal.typeChain().get(goal.typeChain().size() - 1));
    json.writeStringField("state", mission.status(goal));
    if (goal.result().isPresent()) {
      json.writeStringField("result", MissionView.words(goal.result().get()));
    }
    if (goal.reason().isPresent()) {
      json.writeStringField("reason", goal.reason().get());
    }
    json.writeNumberField("timesFinished", times);
    number("arrivedS", mission.arrivedS(goal));
    number("distanceM", mission.distanceM(goal));
    number("timeLimitS", goal.timeLimit());
    json.writeArrayFieldStart("next");
    for (Map.Entry<String, List<String>> next : mission.next(goal).entrySet()) {
      json.writeStartObject();
      if (!next.getKey().isEmpty()) {
        json.writeStringField("when", next.getKey());
      }
      names("goals", next.getValue());
      json.writeEndObject();
    }
    json.writeEndArray();
    json.writeEndObject();
  }

  private void names(String field, List<String> names) throws IOException {
    json.writeArrayFieldStart(field);
    for (String name : names) {
      json.writeString(name);
    }
    json.writeEndArray();
  }

  private void number(String field, OptionalDouble value) throws IOException {
    if (value.isPresent()) {
      json.writeNumberField(field, value.getAsDouble());
    }
  }
}
