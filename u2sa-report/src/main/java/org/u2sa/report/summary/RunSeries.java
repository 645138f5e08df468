package org.u2sa.report.summary;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.Stream;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.report.ReportFile;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.FlightFigures;
import org.u2sa.report.score.RunOutcome;
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
    RunReport first = reports.get(0);
    Domain domain = first.plan().domain();
    Map<String, String> absent = new LinkedHashMap<>();
    SummaryNumbers json =
        new SummaryNumbers(absent, "")
            .put("demo", first.facts().demo())
            .put("simulator", first.facts().simulator())
            .put("success", success())
            .put("runs", reports.size())
            .put("runsSucceeded", reports.stream().filter(r -> r.score().success()).count())
            .number("worstMissM", worst(r -> worstMiss(r.score())), "no waypoint was a target")
            .number(
                "worstCrossTrackRmsM", worst(r -> r.score().crossTrackRmsM()), noStraight(domain));
    if (domain == Domain.AIR) {
      json.number(
              "worstAltitudeErrorM",
              worst(r -> flight(r).altitudeMaxErrorM()),
              "no level leg was flown")
          .number("worstBankDeg", worst(r -> flight(r).maxBankDeg()), "no aircraft took off");
    }
    totals().forEach(json::put);
    json.put("perRun", reports.stream().map(report -> run(absent, report)).toList());
    out.write(json.text());
    out.flush();
  }

  /** Sums of the counts defined by the rules. */
  private Map<String, Integer> totals() {
    Map<String, Integer> totals = new LinkedHashMap<>();
    reports.forEach(
        report ->
            report.score().outcome().counts().forEach((k, v) -> totals.merge(k, v, Integer::sum)));
    return totals;
  }

  private static JsonText run(Map<String, String> absent, RunReport report) {
    RunScore score = report.score();
    RunOutcome outcome = score.outcome();
    SummaryNumbers json =
        new SummaryNumbers(absent, "seed " + report.facts().seed())
            .put("seed", report.facts().seed())
            .put("success", score.success())
            .put("waypoints", score.waypoints().size())
            .put("waypointsCaptured", score.captured())
            .number("worstMissM", worstMiss(score), "no waypoint was a target")
            .number("crossTrackRmsM", score.crossTrackRmsM(), noStraight(report.plan().domain()));
    if (score.flight().isPresent()) {
      FlightFigures flight = score.flight().get();
      json.number("altitudeMaxErrorM", flight.altitudeMaxErrorM(), "no level leg was flown")
          .number("maxBankDeg", flight.maxBankDeg(), "did not take off")
          .put("tookOff", flight.tookOff())
          .put("crashed", outcome.crashed())
          .put("stalled", outcome.stalled());
    } else {
      json.put("contacts", outcome.contacts()).put("violations", outcome.violations().size());
    }
    outcome.counts().forEach(json::put);
    outcome.figures().forEach(json::number);
    return json.number("simSeconds", score.simSeconds())
        .number("wallSeconds", report.facts().wallSeconds())
        .json();
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
