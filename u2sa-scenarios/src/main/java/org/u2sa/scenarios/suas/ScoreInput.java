package org.u2sa.scenarios.suas;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.u2sa.messages.frame.Point;
import org.u2sa.report.ReportFile;
import org.u2sa.scenarios.suas.score.ObjectScore;
import org.u2sa.scenarios.suas.score.ReportedTrack;

/**
 * Writes the data by which a flight is scored to {@code score-input.csv}, for scorers that share no
 * code with the judge: each line is a kind with its numbers or words.
 */
final class ScoreInput {
  private final StringBuilder text = new StringBuilder();

  private ScoreInput() {}

  /**
   * Writes the file.
   *
   * @param out times at which the aircraft was outside the boundary or too high [s]
   */
  static void write(
      SuasField field,
      List<ReportedTrack.Sample> telemetry,
      List<ObjectScore.Sheet> reports,
      List<ObjectScore.Sheet> targets,
      List<Double> out,
      List<Integer> hits,
      Path file) {
    ScoreInput input = new ScoreInput();
    for (Point each : field.waypoints()) {
      input.line("waypoint", each.x(), each.y(), each.z());
    }
    for (ReportedTrack.Sample each : telemetry) {
      input.line("telemetry", each.timeS(), each.eastM(), each.northM(), each.upM());
    }
    out.forEach(each -> input.line("out", each));
    hits.forEach(each -> input.line("obstacle", each));
    targets.forEach(each -> input.sheet("target", each));
    reports.forEach(each -> input.sheet("report", each));
    ReportFile.writeText(file, writer -> writer.write(input.text.toString()));
  }

  private void line(String kind, double... numbers) {
    text.append(kind).append(',');
    text.append(
        DoubleStream.of(numbers)
            .mapToObj(each -> String.format(Locale.ROOT, "%.6f", each))
            .collect(Collectors.joining(",")));
    text.append('\n');
  }

  private void sheet(String kind, ObjectScore.Sheet sheet) {
    text.append(String.format(Locale.ROOT, "%s,%.6f,%.6f,", kind, sheet.eastM(), sheet.northM()));
    text.append(String.join(",", sheet.fields())).append('\n');
  }
}
