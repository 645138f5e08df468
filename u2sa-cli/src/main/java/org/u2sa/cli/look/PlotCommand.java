package org.u2sa.cli.look;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.command.ListeningTime;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.gcs.remote.MessageStream;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.report.message.FieldPath;
import org.u2sa.report.page.Trace;
import org.u2sa.report.picture.SeriesChart;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa plot}: draws fields over time, in the terminal or as a picture. */
@Command(
    name = "plot",
    description = {
      "Plot fields of a running system over time, live in the terminal.",
      "",
      "  ./u2sa plot state.z state.zSigma",
      "  ./u2sa plot state.psi sensed-state.psi --window 60",
      "  ./u2sa plot actuation.percentage --for 20 --png actuation.png",
      "",
      "FIELD is CHANNEL.FIELD, such as state.psi, scans.ranges[3] or objects.objects.size. Each source of a channel (sensor, actuator) is a "
          + "line; each unit has its own chart. If the terminal cannot redraw, the plot is "
          + "printed at the end.",
      "",
      "Exit code 1: no values were received."
    })
public final class PlotCommand extends BaseCommand {
  private static final double MICROS = 1e6;
  private static final double DRAW_EVERY_S = 0.25;
  private static final long LOOK_MS = 50;
  private static final int LABEL_COLUMNS = 14;
  private static final int ROWS = 12;
  private static final double WITHOUT_END_S = 10.0;

  @Mixin private RemoteSystem remote;
  @Mixin private ListeningTime time;

  @Parameters(arity = "1..*", paramLabel = "FIELD", description = "What to plot.")
  private List<String> names;

  @Option(
      names = "--window",
      paramLabel = "S",
      defaultValue = "30",
      description = "Time window shown [s]. Default: ${DEFAULT-VALUE}.")
  private double windowS;

  @Option(
      names = "--png",
      paramLabel = "FILE",
      description = "Write a picture at the end instead of drawing in the terminal.")
  private Path png;

  @Option(names = "--json", description = "Print the values as JSON at the end.")
  private boolean json;

  private record Wanted(String name, Channel<?> channel, FieldPath path) {}

  private final Map<String, Series> series = new LinkedHashMap<>();

  @Override
  public Integer call() throws InterruptedException {
    if (!(windowS > 0.0)) {
      throw wrong("--window " + windowS + ": expected more than 0 s");
    }
    List<Wanted> wanted = names.stream().map(this::wanted).collect(Collectors.toList());
    Terminal terminal = terminal();
    try (RemoteLink link = remote.connect()) {
      MessageStream stream = new MessageStream(link);
      wanted.stream().map(Wanted::channel).distinct().forEach(stream::of);
      long began = link.clock().micros();
      boolean live = png == null && !json && terminal.redraws();
      double nowS = listen(link, stream, wanted, began, live ? terminal : null);
      if (series.isEmpty()) {
        throw new RunFailedException(
            "no values of "
                + String.join(", ", names)
                + " were received from system \""
                + link.systemId()
                + "\"");
      }
      if (live) {
        redraw(terminal, nowS);
      } else {
        show(terminal, nowS);
      }
      return ExitCode.DONE;
    }
  }

  private Wanted wanted(String name) {
    int dot = name.indexOf('.');
    if (dot < 1) {
      throw wrong("\"" + name + "\": expected CHANNEL.FIELD, such as state.psi");
    }
    try {
      return new Wanted(
          name,
          ChannelNames.channel(name.substring(0, dot)),
          FieldPath.parse(name.substring(dot + 1)));
    } catch (IllegalArgumentException e) {
      throw wrong(e.getMessage());
    }
  }

  /** Returns the time at which it ended [s since the start]. */
  private double listen(
      RemoteLink link, MessageStream stream, List<Wanted> wanted, long began, Terminal live)
      throws InterruptedException {
    double drawnS = 0.0;
    while (true) {
      Optional<MessageStream.Heard> heard = stream.next(LOOK_MS);
      heard.ifPresent(each -> take(each, wanted, began));
      long now = link.clock().micros();
      double nowS = (now - began) / MICROS;
      if (live != null && nowS - drawnS >= DRAW_EVERY_S) {
        drawnS = nowS;
        redraw(live, nowS);
        if (live.out().checkError()) {
          return nowS;
        }
      }
      boolean noEnd = live == null && !time.isBounded();
      if (time.isOver(began, now) || noEnd && now - began >= Clock.micros(WITHOUT_END_S)) {
        return nowS;
      }
    }
  }

  private void take(MessageStream.Heard heard, List<Wanted> wanted, long began) {
    for (Wanted each : wanted) {
      OptionalDouble value = each.path.number(heard.message());
      if (heard.channel().equals(each.channel) && value.isPresent()) {
        String source = heard.channel().sourceOf(heard.message());
        String name = source.isEmpty() ? each.name : each.name + " (" + source + ")";
        series
            .computeIfAbsent(name, key -> new Series(name, each.path.unit(heard.message())))
            .add((heard.micros() - began) / MICROS, value.getAsDouble(), windowS);
      }
    }
  }

  private Map<String, List<Series>> byUnit() {
    return series.values().stream()
        .collect(Collectors.groupingBy(Series::unit, LinkedHashMap::new, Collectors.toList()));
  }

  private Map<String, List<Trace>> traces() {
    Map<String, List<Trace>> traces = new LinkedHashMap<>();
    byUnit().forEach((unit, chart) -> traces.put(unit, chart.stream().map(Series::trace).toList()));
    return traces;
  }

  private void show(Terminal terminal, double nowS) {
    if (json) {
      terminal.out().println(json());
    } else if (png == null) {
      draw(terminal, nowS);
    }
    if (png != null) {
      SeriesChart.write(png, traces(), Math.max(0.0, nowS - windowS), nowS);
      if (!json) {
        terminal.out().println(png.toString());
      }
    }
  }

  private void redraw(Terminal terminal, double nowS) {
    terminal.clear();
    draw(terminal, nowS);
  }

  private void draw(Terminal terminal, double nowS) {
    double fromS = nowS - Math.min(windowS, Math.max(1.0, nowS));
    for (List<Series> chart : byUnit().values()) {
      chart.forEach(each -> each.forgetBefore(fromS));
      int columns = Math.max(10, terminal.columns() - LABEL_COLUMNS);
      new TextPlot(columns, ROWS, terminal.colours())
          .lines(chart, fromS, nowS)
          .forEach(terminal.out()::println);
    }
    terminal.out().flush();
  }

  private String json() {
    List<JsonText> all = new ArrayList<>();
    for (Series each : series.values()) {
      List<Double> times = new ArrayList<>();
      List<Double> values = new ArrayList<>();
      for (Series.Sample sample : each.samples()) {
        times.add(sample.timeS());
        values.add(sample.value());
      }
      all.add(
          new JsonText()
              .put("field", each.name())
              .put("unit", each.unit())
              .put("timesS", times)
              .put("values", values));
    }
    return new JsonText().put("series", all).line();
  }
}
