package org.u2sa.gcs.report;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.Writer;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * Writes {@code summary.json}: stable order of keys, numbers rounded to the millimetre, millisecond
 * or thousandth. A number that does not exist is {@code null}, and {@code absent} says why; JSON
 * has no NaN.
 */
final class SummaryJson {

  private static final int DECIMALS = 3;

  private final JsonGenerator json;
  private final Map<String, String> absent = new LinkedHashMap<>();

  private SummaryJson(JsonGenerator json) {
    this.json = json;
  }

  /** Writes the summary and leaves {@code out} open. */
  static void write(Writer out, RunFacts facts, FlightScore score) throws IOException {
    JsonGenerator json = new JsonFactory().createGenerator(out);
    json.disable(JsonGenerator.Feature.AUTO_CLOSE_TARGET);
    json.setPrettyPrinter(
        new DefaultPrettyPrinter().withObjectIndenter(new DefaultIndenter("  ", "\n")));
    new SummaryJson(json).run(facts, score);
    json.close();
    out.write('\n');
    out.flush();
  }

  private void run(RunFacts facts, FlightScore score) throws IOException {
    int planned = score.waypoints().size();
    json.writeStartObject();
    json.writeStringField("demo", facts.demo());
    json.writeNumberField("seed", facts.seed());
    json.writeStringField("simulator", facts.simulator());
    json.writeBooleanField("success", score.success());
    json.writeNumberField("waypoints", planned);
    json.writeNumberField("waypointsCaptured", score.captured());
    json.writeNumberField("goals", planned);
    json.writeNumberField("goalsCompleted", facts.goalsCompleted().orElse(score.captured()));
    json.writeArrayFieldStart("perWaypoint");
    for (WaypointResult result : score.waypoints()) {
      waypoint(result);
    }
    json.writeEndArray();
    flight(score);
    outcome(score.outcome());
    number("simSeconds", score.simSeconds());
    number("wallSeconds", facts.wallSeconds());
    number(
        "simSecondsPerSecond",
        facts.wallSeconds() > 0.0
            ? OptionalDouble.of(score.simSeconds() / facts.wallSeconds())
            : OptionalDouble.empty(),
        "no wall time was measured");
    absences();
    json.writeEndObject();
  }

  private void waypoint(WaypointResult result) throws IOException {
    String name = result.waypoint().name();
    json.writeStartObject();
    json.writeStringField("name", name);
    String never = "never was the target";
    number("missM", result.missM(), never, name);
    number(
        "altitudeErrorM",
        result.altitudeErrorM(),
        result.missM().isPresent() ? "has no planned altitude" : never,
        name);
    number("timeS", result.timeS(), never, name);
    json.writeBooleanField("captured", result.captured());
    json.writeEndObject();
  }

  private void flight(FlightScore score) throws IOException {
    String noStraight = "no straight between waypoints was flown";
    number("crossTrackRmsM", score.crossTrackRmsM(), noStraight);
    number("crossTrackRmsWholeLegsM", score.crossTrackRmsWholeLegsM(), noStraight);
    number("settlingDistanceM", FlightScorer.SETTLING_DISTANCE_M);
    String noLevel = "no leg between waypoints of one altitude was flown";
    number("altitudeRmsM", score.altitudeRmsM(), noLevel);
    number("altitudeMaxErrorM", score.altitudeMaxErrorM(), noLevel);
    String noFlight = "the vehicle did not take off";
    number("maxBankDeg", degrees(score.maxBankRad()), noFlight);
    number("minAirspeedMps", score.minAirspeedMps(), noFlight);
    json.writeBooleanField("tookOff", score.tookOff());
  }

  private void outcome(FlightOutcome outcome) throws IOException {
    json.writeBooleanField("crashed", outcome.crashed());
    json.writeBooleanField("stalled", outcome.stalled());
    json.writeNumberField("contacts", outcome.crashed() ? 1 : 0);
    json.writeNumberField("violations", outcome.violations().size());
    json.writeArrayFieldStart("violationDetails");
    for (String violation : outcome.violations()) {
      json.writeString(violation);
    }
    json.writeEndArray();
  }

  private void absences() throws IOException {
    json.writeObjectFieldStart("absent");
    for (Map.Entry<String, String> entry : absent.entrySet()) {
      json.writeStringField(entry.getKey(), entry.getValue());
    }
    json.writeEndObject();
  }

  private void number(String key, OptionalDouble value, String reasonIfAbsent, String of)
      throws IOException {
    if (value.isEmpty()) {
      absent.put(of + ": " + key, reasonIfAbsent);
    }
    valueOrNull(key, value);
  }

  private void number(String key, OptionalDouble value, String reasonIfAbsent) throws IOException {
    if (value.isEmpty()) {
      absent.put(key, reasonIfAbsent);
    }
    valueOrNull(key, value);
  }

  private void valueOrNull(String key, OptionalDouble value) throws IOException {
    if (value.isPresent()) {
      number(key, value.getAsDouble());
    } else {
      json.writeNullField(key);
    }
  }

  private void number(String key, double value) throws IOException {
    json.writeFieldName(key);
    json.writeNumber(BigDecimal.valueOf(value).setScale(DECIMALS, RoundingMode.HALF_EVEN));
  }

  private static OptionalDouble degrees(OptionalDouble radians) {
    return radians.isPresent() ? OptionalDouble.of(Math.toDegrees(radians.getAsDouble())) : radians;
  }
}
