package org.u2sa.cli.record;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.cli.terminal.TextTable;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.recorder.execution.ChannelComparison;
import org.u2sa.recorder.execution.NumberComparison;
import org.u2sa.recorder.execution.Rerun;

/** Reports the results of re-executing services. */
final class RerunReport {
  private static final int MAX_FIELDS = 12; // per channel, in the text

  private final List<Rerun.Outcome> outcomes;
  private final double wallS;
  private final boolean withDeviations;

  RerunReport(List<Rerun.Outcome> outcomes, double wallS, boolean withDeviations) {
    this.outcomes = List.copyOf(outcomes);
    this.wallS = wallS;
    this.withDeviations = withDeviations;
  }

  boolean isIdentical() {
    return outcomes.stream().allMatch(Rerun.Outcome::isIdentical);
  }

  List<String> lines() {
    TextTable table =
        new TextTable("SERVICE", "CHANNEL", "RECORDED", "NOW", "SAME", "FIRST DIFFERENCE");
    for (Rerun.Outcome outcome : outcomes) {
      for (ChannelComparison channel : outcome.channels()) {
        table.add(
            outcome.execution(),
            channel.name(),
            Long.toString(channel.recorded()),
            Long.toString(channel.now()),
            Long.toString(channel.same()),
            channel.first().map(RerunReport::text).orElse(""));
      }
    }
    List<String> lines = new ArrayList<>(table.lines());
    if (withDeviations) {
      lines.addAll(deviations());
    }
    for (Rerun.Outcome outcome : outcomes) {
      outcome.remarks().forEach(remark -> lines.add(outcome.execution() + ": " + remark));
    }
    lines.add(summary());
    return lines;
  }

  /** First difference on a channel, in words. */
  static String text(ChannelComparison.Difference difference) {
    String field = difference.field().field();
    return String.format(
        Locale.ROOT,
        "%.6f s%s: %s recorded, %s now",
        Clock.seconds(difference.micros()),
        field.isEmpty() ? "" : ", " + field,
        shortened(difference.field().recorded()),
        shortened(difference.field().now()));
  }

  private static String shortened(String value) {
    int most = 60;
    if (value.isEmpty()) {
      return "nothing";
    }
    return value.length() <= most ? value : value.substring(0, most) + "…";
  }

  private List<String> deviations() {
    TextTable table = new TextTable("SERVICE", "CHANNEL", "FIELD", "RMS", "LARGEST", "UNIT");
    boolean any = false;
    for (Rerun.Outcome outcome : outcomes) {
      for (ChannelComparison channel : outcome.channels()) {
        int count = 0;
        for (NumberComparison field : channel.numbers()) {
          any = true;
          if (count++ < MAX_FIELDS) {
            table.add(
                outcome.execution(),
                channel.name(),
                field.name(),
                number(field.rms()),
                number(field.largest()),
                field.unit());
          }
        }
        if (count > MAX_FIELDS) {
          table.add(
              outcome.execution(), channel.name(), (count - MAX_FIELDS) + " more", "", "", "");
        }
      }
    }
    List<String> lines = new ArrayList<>();
    if (any) {
      lines.add("");
      lines.addAll(table.lines());
      lines.add("");
    }
    return lines;
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.6g", value);
  }

  private String summary() {
    long recorded = 0;
    long same = 0;
    double simS = 0.0;
    for (Rerun.Outcome outcome : outcomes) {
      for (ChannelComparison channel : outcome.channels()) {
        recorded += channel.recorded();
        same += channel.same();
      }
      simS = Math.max(simS, Clock.seconds(outcome.micros()));
    }
    return String.format(
        Locale.ROOT,
        "%s: %d of %d messages are identical, not counting health reports; %.1f s executed in %.1f"
            + " s, %.1f times as fast as recorded",
        isIdentical() ? "Identical" : "Not identical",
        same,
        recorded,
        simS,
        wallS,
        wallS == 0.0 ? 0.0 : simS / wallS);
  }

  List<String> json() {
    List<JsonText> services = new ArrayList<>();
    for (Rerun.Outcome outcome : outcomes) {
      List<JsonText> channels = outcome.channels().stream().map(this::json).toList();
      services.add(
          new JsonText()
              .put("service", outcome.execution())
              .put("identical", outcome.isIdentical())
              .put("simSeconds", Clock.seconds(outcome.micros()))
              .put("remarks", outcome.remarks())
              .put("channels", channels));
    }
    return List.of(
        new JsonText()
            .put("identical", isIdentical())
            .put("wallSeconds", wallS)
            .put("services", services)
            .toString());
  }

  private JsonText json(ChannelComparison channel) {
    JsonText json =
        new JsonText()
            .put("channel", channel.name())
            .put("recorded", channel.recorded())
            .put("now", channel.now())
            .put("same", channel.same());
    channel
        .first()
        .ifPresent(
            first ->
                json.put(
                    "firstDifference",
                    new JsonText()
                        .put("timeS", Clock.seconds(first.micros()))
                        .put("field", first.field().field())
                        .put("recorded", first.field().recorded())
                        .put("now", first.field().now())));
    if (withDeviations) {
      List<JsonText> fields = new ArrayList<>();
      for (NumberComparison field : channel.numbers()) {
        fields.add(
            new JsonText()
                .put("field", field.name())
                .put("unit", field.unit())
                .put("rms", field.rms())
                .put("largest", field.largest()));
      }
      json.put("deviations", fields);
    }
    return json;
  }
}
