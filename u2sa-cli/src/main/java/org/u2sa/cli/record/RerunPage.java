package org.u2sa.cli.record;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.recorder.execution.ChannelComparison;
import org.u2sa.recorder.execution.NumberComparison;
import org.u2sa.recorder.execution.Rerun;
import org.u2sa.report.page.Chart;
import org.u2sa.report.page.RunPage;
import org.u2sa.report.page.Trace;

/** Report page that overlays re-executed services' output on the recorded output. */
final class RerunPage {
  private static final int MAX_CHARTS = 12; // per channel

  private final Side recorded = new Side("recorded");
  private final Side now = new Side("now");
  private double endS;

  /** One of the two compared runs. */
  private static final class Side {
    private final String name;
    private final List<JsonText> figures = new ArrayList<>();
    private final List<JsonText> charts = new ArrayList<>();
    private final List<JsonText> events = new ArrayList<>();
    private final List<JsonText> facts = new ArrayList<>();

    Side(String name) {
      this.name = name;
    }

    void figure(String what, double value, String unit) {
      figures.add(new JsonText().put("name", what).put("value", value).put("unit", unit));
    }

    void chart(String title, String unit, Trace... lines) {
      charts.add(new Chart(title, unit, List.of(lines), null).json());
    }

    void fact(String what, String value) {
      facts.add(new JsonText().put("name", what).put("value", value));
    }

    JsonText json(double durationS) {
      return new JsonText()
          .put("name", name)
          .put("durationS", durationS)
          .put("figures", figures)
          .put("charts", charts)
          .put("timeline", new JsonText().put("events", events).put("leftOut", 0))
          .put("facts", facts);
    }
  }

  private RerunPage() {}

  /** Writes the page; {@code changes} are those the user asked for. */
  static void write(Path page, Path recording, List<Rerun.Outcome> outcomes, List<String> changes) {
    RerunPage all = new RerunPage();
    all.recorded.fact("file", recording.toString());
    changes.forEach(change -> all.now.fact("changed", change));
    outcomes.forEach(all::add);
    RunPage.write(
        page,
        recording + (changes.isEmpty() ? " again" : " against " + String.join(", ", changes)),
        List.of(all.recorded.json(all.endS), all.now.json(all.endS)));
  }

  private void add(Rerun.Outcome outcome) {
    double startS = Clock.seconds(outcome.startMicros());
    endS = Math.max(endS, Clock.seconds(outcome.micros()));
    outcome.remarks().forEach(remark -> now.fact(outcome.execution(), remark));
    for (ChannelComparison channel : outcome.channels()) {
      String title = outcome.execution() + ": " + channel.name();
      recorded.figure(title + ", messages", channel.recorded(), "");
      now.figure(title + ", messages", channel.now(), "");
      now.figure(title + ", the same", channel.same(), "");
      channel
          .first()
          .ifPresent(
              first ->
                  now.events.add(
                      new JsonText()
                          .put("t", Clock.seconds(first.micros()) - startS)
                          .put("kind", "first difference")
                          .put("text", title + " " + RerunReport.text(first))
                          .put("bad", true)));
      List<NumberComparison> numbers = channel.numbers();
      numbers.stream().limit(MAX_CHARTS).forEach(number -> add(title, startS, number));
      if (numbers.size() > MAX_CHARTS) {
        now.fact(title, numbers.size() - MAX_CHARTS + " more numbers differ");
      }
    }
  }

  private void add(String channel, double startS, NumberComparison number) {
    String title = channel + ", " + number.name();
    now.figure(title + ", deviation, root mean square", number.rms(), number.unit());
    now.figure(title + ", deviation, maximum", number.largest(), number.unit());
    Trace before = new Trace("");
    Trace after = new Trace("");
    Trace difference = new Trace("now − recorded");
    number.forEach(
        (timeS, was, is) -> {
          add(before, timeS - startS, was);
          add(after, timeS - startS, is);
          add(difference, timeS - startS, number.deviation(was, is));
        });
    recorded.chart(title, number.unit(), before);
    now.chart(title, number.unit(), after);
    recorded.chart(title + ", difference", number.unit()); // adds it after the previous chart
    now.chart(title + ", difference", number.unit(), difference);
  }

  private static void add(Trace trace, double timeS, double value) {
    if (!Double.isNaN(value)) {
      trace.add(timeS, value);
    }
  }
}
