package org.u2sa.report.summary;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.Writer;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.FlightFigures;
import org.u2sa.report.score.ObstacleResult;
import org.u2sa.report.score.RunDetails;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunScore;
import org.u2sa.report.score.WaypointResult;

/** Writes {@code summary.json} of one run, keys in a fixed order. */
final class SummaryJson {

  /** Waypoint radius of IGVC's qualification, independent of the mission [m]. */
  private static final double QUALIFYING_M = 2.0;

  private final SummaryNumbers numbers;
  private final JsonGenerator json;

  private SummaryJson(SummaryNumbers numbers) {
    this.numbers = numbers;
    json = numbers.generator();
  }

  /** Writes the summary; does not close {@code out}. */
  static void write(Writer out, Domain domain, RunDetails facts, RunScore score)
      throws IOException {
    try (SummaryNumbers numbers = new SummaryNumbers(out)) {
      new SummaryJson(numbers).run(domain, facts, score);
    }
  }

  private void run(Domain domain, RunDetails facts, RunScore score) throws IOException {
    int planned = score.waypoints().size();
    json.writeStartObject();
    json.writeStringField("demo", facts.demo());
    json.writeNumberField("seed", facts.seed());
    json.writeStringField("simulator", facts.simulator());
    json.writeBooleanField("success", score.success());
    json.writeNumberField("waypoints", planned);
    json.writeNumberField("waypointsCaptured", score.captured());
    if (domain == Domain.GROUND) {
      json.writeNumberField("waypointsWithin2M", score.within(QUALIFYING_M));
    }
    json.writeNumberField("goals", facts.goals().orElse(planned));
    json.writeNumberField("goalsCompleted", facts.goalsCompleted().orElse(score.captured()));
    json.writeArrayFieldStart("perWaypoint");
    for (WaypointResult result : score.waypoints()) {
      waypoint(domain, result);
    }
    json.writeEndArray();
    straights(domain, score);
    if (score.flight().isPresent()) {
      flight(score.flight().get());
      json.writeBooleanField("crashed", score.outcome().crashed());
      json.writeBooleanField("stalled", score.outcome().stalled());
    }
    if (!score.obstacles().isEmpty()) {
      obstacles(score.obstacles());
    }
    outcome(score.outcome());
    numbers.number("simSeconds", score.simSeconds());
    numbers.number("wallSeconds", facts.wallSeconds());
    OptionalDouble rate =
        facts.wallSeconds() > 0.0
            ? OptionalDouble.of(score.simSeconds() / facts.wallSeconds())
            : OptionalDouble.empty();
    numbers.number("simSecondsPerSecond", rate, "no wall time was measured");
    numbers.absences();
    json.writeEndObject();
  }

  private void waypoint(Domain domain, WaypointResult result) throws IOException {
    String name = result.waypoint().name();
    json.writeStartObject();
    json.writeStringField("name", name);
    String never = "never was the target";
    numbers.number("missM", result.missM(), never, name);
    if (domain == Domain.AIR) {
      numbers.number(
          "altitudeErrorM",
          result.altitudeErrorM(),
          result.missM().isPresent() ? "has no planned altitude" : never,
          name);
    }
    numbers.number("timeS", result.timeS(), never, name);
    json.writeBooleanField("captured", result.captured());
    json.writeEndObject();
  }

  private void straights(Domain domain, RunScore score) throws IOException {
    String noStraight = "no straight between waypoints was " + domain.moved();
    numbers.number("crossTrackRmsM", score.crossTrackRmsM(), noStraight);
    numbers.number("crossTrackRmsWholeLegsM", score.crossTrackRmsWholeLegsM(), noStraight);
    numbers.number("settlingDistanceM", domain.settlingDistanceM());
  }

  private void flight(FlightFigures score) throws IOException {
    String noLevel = "no leg between waypoints of one altitude was flown";
    numbers.number("altitudeRmsM", score.altitudeRmsM(), noLevel);
    numbers.number("altitudeMaxErrorM", score.altitudeMaxErrorM(), noLevel);
    String noFlight = "the vehicle did not take off";
    numbers.number("maxBankDeg", score.maxBankDeg(), noFlight);
    numbers.number("minAirspeedMps", score.minAirspeedMps(), noFlight);
    json.writeBooleanField("tookOff", score.tookOff());
  }

  private void obstacles(List<ObstacleResult> results) throws IOException {
    json.writeArrayFieldStart("obstacles");
    for (ObstacleResult result : results) {
      json.writeStartObject();
      json.writeStringField("name", result.name());
      json.writeBooleanField("moves", result.moves());
      numbers.number("leastDistanceM", result.leastM());
      numbers.number("timeS", result.timeS());
      json.writeBooleanField("touched", result.touched());
      json.writeEndObject();
    }
    json.writeEndArray();
  }

  private void outcome(RunOutcome outcome) throws IOException {
    for (Map.Entry<String, Integer> count : outcome.counts().entrySet()) {
      json.writeNumberField(count.getKey(), count.getValue());
    }
    for (Map.Entry<String, Double> figure : outcome.figures().entrySet()) {
      numbers.number(figure.getKey(), figure.getValue());
    }
    json.writeNumberField("contacts", outcome.contacts());
    json.writeNumberField("violations", outcome.violations().size());
    json.writeArrayFieldStart("violationDetails");
    for (String violation : outcome.violations()) {
      json.writeString(violation);
    }
    json.writeEndArray();
  }
}
