package org.u2sa.report.run;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.record.McapMetadata;
import org.u2sa.recorder.playback.RecordedMessages;
import org.u2sa.recorder.playback.RecordedSpan;
import org.u2sa.report.page.Chart;
import org.u2sa.report.page.Trace;

/** Content of a report on one recording, read in one pass. */
public final class RunContent {
  private static final double NANOS = 1e9;
  private static final double MILLIS = 1e3;
  private static final double OTHER_CLOCK_S = 86_400.0;

  private final String name;
  private final RunMap map;
  private final RunTimeline timeline = new RunTimeline();
  private final HopLatency latency = new HopLatency();
  private final Map<String, Trace> callbacks = new LinkedHashMap<>();
  private final TruthTrack truth; // null if unknown
  private final StateCharts charts;
  private final double truthFromS;
  private final long startNanos;
  private final double durationS;
  private final List<JsonText> facts = new ArrayList<>();
  private final Set<String> goals = new HashSet<>();
  private final Set<String> goalsReached = new HashSet<>();
  private boolean isShortened; // goals or services were left out

  private RunContent(Path file, McapReader reader, TruthTrack truth, Optional<Geodetic> origin) {
    map = new RunMap(origin);
    name = name(file);
    startNanos = reader.statistics().startNanos();
    boolean simulated = startNanos < OTHER_CLOCK_S * NANOS;
    this.truth = simulated ? truth : null; // its start is unknown in real time
    durationS = (reader.statistics().endNanos() - startNanos) / NANOS;
    truthFromS = -startNanos / NANOS; // both are relative to the start of simulated time
    charts = new StateCharts(map, this.truth, truthFromS);
  }

  /** Name of the run: its folder if the file has its default name. */
  private static String name(Path file) {
    Path folder = file.toAbsolutePath().getParent();
    String own = file.getFileName().toString().replaceFirst("\\.mcap$", "");
    return own.equals("recording") && folder != null && folder.getFileName() != null
        ? folder.getFileName().toString()
        : own;
  }

  /**
   * Reads a recording.
   *
   * @param truthFile a demo's track.csv; empty: the one in the recording's folder, if any
   * @throws BadInputException if it contains no published messages
   */
  public static RunContent read(Path file, Optional<Path> truthFile) throws IOException {
    return read(file, truthFile, Optional.empty());
  }

  /**
   * Reads recordings that are compared, on one map; each track.csv is that in the recording's
   * folder, if any.
   *
   * @throws BadInputException if one contains no published messages
   */
  public static List<RunContent> readAll(List<Path> files) throws IOException {
    List<RunContent> runs = new ArrayList<>();
    Optional<Geodetic> origin = Optional.empty();
    for (Path file : files) {
      RunContent run = read(file, Optional.empty(), origin);
      runs.add(run);
      origin = origin.or(run.map::origin);
    }
    return runs;
  }

  private static RunContent read(Path file, Optional<Path> truthFile, Optional<Geodetic> origin)
      throws IOException {
    Path beside = file.resolveSibling("track.csv");
    TruthTrack truth = null;
    if (truthFile.isPresent()) {
      truth = TruthTrack.read(truthFile.get());
    } else if (Files.isRegularFile(beside)) {
      truth = TruthTrack.read(beside);
    }
    try (RecordedMessages recording = RecordedMessages.open(file).requireMessages()) {
      McapReader reader = recording.reader();
      RunContent content = new RunContent(file, reader, truth, origin);
      content.facts(file, reader);
      recording.forEach(recording.channels(List.of()), RecordedSpan.all(reader), content::take);
      if (content.isShortened || content.map.isShortened() || content.latency.isShortened()) {
        content.fact("left out", "goals, objects, services or channels beyond the report's limits");
      }
      recording.undecodable().ifPresent(what -> content.fact("not decoded", what));
      return content;
    }
  }

  private void facts(Path file, McapReader reader) throws IOException {
    fact("file", file.toString());
    if (truth == null) {
      fact("truth", "not known: no track.csv of a run in simulated time");
    }
    fact("messages", String.valueOf(reader.statistics().messages()));
    for (McapMetadata metadata : reader.metadata()) {
      metadata.entries().forEach((key, value) -> fact(metadata.name() + " " + key, value));
    }
    for (String attachment : reader.attachmentNames()) {
      if (attachment.endsWith(".log")) {
        byte[] data = reader.attachment(attachment).orElseThrow().data();
        long lines =
            new String(data, StandardCharsets.UTF_8)
                .lines()
                .filter(line -> line.contains(" | WARN | ") || line.contains(" | ERROR | "))
                .count();
        if (lines > 0) {
          fact(attachment, lines + " warnings and errors; ./u2sa log " + file + " --level warn");
        }
      }
    }
  }

  private void fact(String key, String value) {
    facts.add(new JsonText().put("name", key).put("value", value));
  }

  private void take(Topic topic, U2SAData message, long logNanos) {
    double timeS = (logNanos - startNanos) / NANOS;
    double measuredS =
        message.timestamp().isPresent()
            ? (message.timestamp().getAsLong() * MILLIS - startNanos) / NANOS
            : timeS;
    if (message.timestamp().isPresent() && Math.abs(timeS - measuredS) < OTHER_CLOCK_S) {
      latency.take(topic.channel(), timeS, timeS - measuredS);
    }
    timeline.take(timeS, message);
    if (message instanceof StateInformation state
        && topic.channel().equals(Channels.STATE.name())) {
      charts.take(measuredS, state);
    } else if (message instanceof StateInformation state
        && topic.channel().equals(Channels.LOCAL_STATE.name())) {
      map.takeLocal(state);
    } else if (message instanceof OccupancyGrid grid) {
      map.take(grid);
    } else if (message instanceof GoalList list) {
      charts.take(list);
      list.goals().forEach(goal -> count(goal, goals));
    } else if (message instanceof GoalInformation goal
        && topic.channel().equals(Channels.GOAL_REPORTS.name())) {
      map.take(goal);
      count(goal, goals);
      if (goal.completed() && !goal.abandoned()) {
        count(goal, goalsReached);
      }
    } else if (message instanceof ObjectList objects) {
      map.take(objects);
    } else if (message instanceof PercentageCommand command) {
      charts.take(timeS, command);
    } else if (message instanceof HealthReport report && report.callbackP99().isPresent()) {
      callback(report.serviceName(), timeS, report.callbackP99().getAsDouble() * MILLIS);
    }
  }

  private void count(GoalInformation goal, Set<String> among) {
    if (among.size() < ReportLimits.MAX_GOALS) {
      among.add(ReportLimits.clipped(goal.uid()));
    } else {
      isShortened = true;
    }
  }

  private void callback(String service, double timeS, double millis) {
    String name = ReportLimits.clipped(service);
    if (callbacks.size() < ReportLimits.MAX_SOURCES || callbacks.containsKey(name)) {
      callbacks.computeIfAbsent(name, Trace::new).add(timeS, millis);
    } else {
      isShortened = true;
    }
  }

  /** The content for the page. */
  public JsonText json() {
    List<JsonText> drawn = new ArrayList<>();
    List<Chart> all = new ArrayList<>(charts.charts());
    all.add(latency.chart());
    all.add(
        new Chart(
            "Callback time of services, 99th percentile",
            "ms",
            List.copyOf(callbacks.values()),
            null));
    all.stream().filter(chart -> !chart.isEmpty()).forEach(chart -> drawn.add(chart.json()));
    return new JsonText()
        .put("name", name)
        .put("durationS", Trace.rounded(durationS))
        .put("figures", figures())
        .put("map", map.json(truth, truthFromS))
        .put("charts", drawn)
        .put("latency", latency.rows(durationS))
        .put("timeline", timeline.json())
        .put("facts", facts);
  }

  /** Metrics for comparing runs: name, value, unit. */
  private List<JsonText> figures() {
    List<JsonText> figures = new ArrayList<>();
    figures.add(figure("duration", Trace.rounded(durationS), "s"));
    figures.add(figure("goals reached", (double) goalsReached.size(), ""));
    figures.add(figure("goals begun", (double) goals.size(), ""));
    Trace off = charts.crossTrack();
    if (off.size() > 0) {
      figures.add(
          figure("cross-track error, root mean square", Trace.rounded(off.rootMeanSquare()), "m"));
      figures.add(
          figure("cross-track error, maximum", Trace.rounded(off.greatestMagnitude()), "m"));
    }
    if (charts.positionErrorRms() != null) {
      figures.add(figure("position error, root mean square", charts.positionErrorRms(), "m"));
    }
    figures.add(figure("failsafes", (double) timeline.count("failsafe", true), ""));
    figures.add(figure("services not alive", (double) timeline.servicesNotAlive(), ""));
    figures.add(figure("emergency stops", (double) timeline.count("stop", true), ""));
    figures.add(
        figure("configuration changes", (double) timeline.count("configuration", false), ""));
    return figures;
  }

  private static JsonText figure(String name, double value, String unit) {
    return new JsonText().put("name", name).put("value", value).put("unit", unit);
  }
}
