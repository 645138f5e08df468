package org.u2sa.report.summary;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.Writer;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.Stream;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.report.ReportFile;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.FlightFigures;
import org.u2sa.report.score.RunScore;
import org.u2sa.report.score.WaypointResult;

/**
 * Several runs of one mission with different seeds: the worst value of each metric, and one line
 * per run.
 *
 * @param reports the runs in order of execution, at least one
 */
public record RunSeries(List<RunReport> reports) {

  /**
   * @throws IllegalArgumentException if empty
   */
  public RunSeries {
    reports = List.copyOf(reports);
    if (reports.isEmpty()) {
      throw new IllegalArgumentException("a series has at least one run");
    }
  }

  /** Whether every run succeeded. */
  public boolean success() {
    return reports.stream().allMatch(report -> report.score().success());
  }

  /**
   * Writes the series' {@code summary.json} into {@code directory}, beside the directories of its
   * runs.
   *
   * @throws RunFailedException if it cannot be written
   */
  public void write(Path directory) {
    ReportFile.writeText(directory.resolve(RunReport.SUMMARY), this::writeSummary);
  }

  /** Writes the same content for {@code --json}; does not close {@code out}. */
  public void writeSummary(Writer out) throws IOException {
    try (SummaryNumbers json = new SummaryNumbers(out)) {
      JsonGenerator generator = json.generator();
      generator.writeStartObject();
      generator.writeStringField("demo", reports.get(0).facts().demo());
      generator.writeStringField("simulator", reports.get(0).facts().simulator());
      generator.writeBooleanField("success", success());
      generator.writeNumberField("runs", reports.size());
      generator.writeNumberField(
          "runsSucceeded", reports.stream().filter(r -> r.score().success()).count());
      json.number("worstMissM", worst(r -> worstMiss(r.score())), "no waypoint was a target");
      Domain domain = reports.get(0).plan().domain();
      json.number(
          "worstCrossTrackRmsM", worst(r -> r.score().crossTrackRmsM()), noStraight(domain));
      if (domain == Domain.AIR) {
        json.number(
            "worstAltitudeErrorM",
            worst(r -> flight(r).altitudeMaxErrorM()),
            "no level leg was flown");
        json.number("worstBankDeg", worst(r -> flight(r).maxBankDeg()), "nothing took off");
      }
      for (Map.Entry<String, Integer> total : totals().entrySet()) {
        generator.writeNumberField(total.getKey(), total.getValue());
      }
      generator.writeArrayFieldStart("perRun");
      for (RunReport report : reports) {
        run(json, report);
      }
      generator.writeEndArray();
      json.absences();
      generator.writeEndObject();
    }
  }

  /** Sums of the counts by the rules. */
  private Map<String, Integer> totals() {
    Map<String, Integer> totals = new LinkedHashMap<>();
    for (RunReport report : reports) {
      report
          .score()
          .outcome()
          .counts()
          .forEach((name, count) -> totals.merge(name, count, Integer::sum));
    }
    return totals;
  }

  private static void run(SummaryNumbers json, RunReport report) throws IOException {
    RunScore score = report.score();
    String of = "seed " + report.facts().seed();
    JsonGenerator generator = json.generator();
    generator.writeStartObject();
    generator.writeNumberField("seed", report.facts().seed());
    generator.writeBooleanField("success", score.success());
    generator.writeNumberField("waypoints", score.waypoints().size());
    generator.writeNumberField("waypointsCaptured", score.captured());
    json.number("worstMissM", worstMiss(score), "no waypoint was a target", of);
    json.number("crossTrackRmsM", score.crossTrackRmsM(), noStraight(report.plan().domain()), of);
    if (score.flight().isPresent()) {
      flight(json, score.flight().get(), of);
      generator.writeBooleanField("crashed", score.outcome().crashed());
      generator.writeBooleanField("stalled", score.outcome().stalled());
    } else {
      generator.writeNumberField("contacts", score.outcome().contacts());
      generator.writeNumberField("violations", score.outcome().violations().size());
    }
    for (Map.Entry<String, Integer> count : score.outcome().counts().entrySet()) {
      generator.writeNumberField(count.getKey(), count.getValue());
    }
    for (Map.Entry<String, Double> figure : score.outcome().figures().entrySet()) {
      json.number(figure.getKey(), figure.getValue());
    }
    json.number("simSeconds", score.simSeconds());
    json.number("wallSeconds", report.facts().wallSeconds());
    generator.writeEndObject();
  }

  private static void flight(SummaryNumbers json, FlightFigures flight, String of)
      throws IOException {
    json.number("altitudeMaxErrorM", flight.altitudeMaxErrorM(), "no level leg was flown", of);
    json.number("maxBankDeg", flight.maxBankDeg(), "did not take off", of);
    json.generator().writeBooleanField("tookOff", flight.tookOff());
  }

  private static FlightFigures flight(RunReport report) {
    return report.score().flight().orElseThrow();
  }

  private static String noStraight(Domain domain) {
    return "no straight was " + domain.moved();
  }

  private static OptionalDouble worstMiss(RunScore score) {
    return largest(score.waypoints().stream().map(WaypointResult::missM));
  }

  private OptionalDouble worst(Function<RunReport, OptionalDouble> figure) {
    return largest(reports.stream().map(figure));
  }

  private static OptionalDouble largest(Stream<OptionalDouble> values) {
    return values.flatMapToDouble(OptionalDouble::stream).max();
  }
}
