package org.u2sa.cli.report;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.command.ProgramVersion;
import org.u2sa.cli.record.RecordingParts;
import org.u2sa.cli.record.SpanOptions;
import org.u2sa.interfaces.JsonText;
import org.u2sa.recorder.playback.RecordedMessages;
import org.u2sa.recorder.playback.RecordedSpan;
import org.u2sa.report.ReportFile;
import org.u2sa.report.export.CsvTables;
import org.u2sa.report.export.GeoJsonText;
import org.u2sa.report.export.GeoRun;
import org.u2sa.report.export.GpxText;
import org.u2sa.report.export.KmlText;
import org.u2sa.report.export.UlogRecording;
import org.u2sa.report.export.ViewerRecording;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa export}: exports a recording as tables, or as tracks for maps. */
@Command(
    name = "export",
    description = {
      "Export a recording as CSV, KML, GPX, GeoJSON or ULog, or for viewers without CBOR.",
      "",
      "  ./u2sa export recording.mcap --format csv --channel state,actuation --out tables",
      "  ./u2sa export recording.mcap --format kml",
      "  ./u2sa export recording.mcap --format mcap",
      "",
      "csv: a folder with a table for each topic: time of recording [s], then each field that occurs in any message of the topic, with "
          + "its unit. Lists and messages within a message are JSON.",
      "kml, gpx, geojson: tracks of the states in the frame GLOBAL, one for each source, and the goals. Default channel: state.",
      "mcap: a recording whose messages are JSON, for Foxglove, Lichtblick and PlotJuggler; with its views, unless --channel names channels.",
      "ulog: the numbers of all messages in PX4's log format, for pyulog and PlotJuggler."
    })
public final class ExportCommand extends BaseCommand {
  @Mixin private SpanOptions part;

  @Parameters(paramLabel = "FILE", description = "The recording (MCAP).")
  private Path file;

  enum Format {
    csv,
    kml,
    gpx,
    geojson,
    mcap,
    ulog
  }

  @Option(
      names = "--format",
      required = true,
      paramLabel = "FORMAT",
      description = "One of ${COMPLETION-CANDIDATES}.")
  private Format format;

  @Option(
      names = "--channel",
      paramLabel = "NAME",
      split = ",",
      description = "Only these channels, for example state,actuation.")
  private List<String> channels = List.of();

  @Option(
      names = "--every",
      paramLabel = "S",
      defaultValue = "0",
      description =
          "Minimum interval between messages of a topic [s]; others are skipped. Default: all.")
  private double everyS;

  @Option(
      names = {"-o", "--out"},
      paramLabel = "PATH",
      description = "Output file; for csv, a folder. Default: beside the recording, with its name.")
  private Path out;

  @Option(
      names = "--json",
      description = "Print JSON that lists what was written, one object per file.")
  private boolean json;

  @Override
  public Integer call() throws IOException {
    if (!(everyS >= 0.0)) {
      throw wrong("--every " + everyS + ": expected 0 s or more");
    }
    try (RecordedMessages recording = RecordedMessages.open(file).requireMessages()) {
      RecordedSpan span = part.of(recording.reader());
      if (format == Format.csv) {
        tables(recording, span);
      } else if (format == Format.mcap) {
        viewers(recording, span);
      } else if (format == Format.ulog) {
        ulog(recording, span);
      } else {
        map(recording, span);
      }
      recording.undecodable().ifPresent(what -> tell(what));
    }
    RecordingParts.othersNotRead(file).ifPresent(this::tell);
    return ExitCode.DONE;
  }

  private Path target(String suffix) {
    String name = file.getFileName().toString().replaceFirst("\\.mcap$", "");
    return out == null ? file.resolveSibling(name + suffix) : out;
  }

  private void tables(RecordedMessages recording, RecordedSpan span) throws IOException {
    CsvTables tables = new CsvTables(recording, span, recording.channels(channels), everyS);
    tables.write(target("-csv")).forEach((table, rows) -> say(table, Map.of("rows", rows)));
  }

  private void say(Path written, Map<String, Long> counts) {
    if (json) {
      JsonText line = new JsonText().put("file", written.toString());
      counts.forEach(line::put);
      print(line.line());
    } else {
      print(
          counts.entrySet().stream()
              .map(count -> count.getValue() + " " + count.getKey())
              .collect(Collectors.joining(", ", written + " (", ")")));
    }
  }

  private void viewers(RecordedMessages recording, RecordedSpan span) throws IOException {
    Path target = target("-viewer.mcap");
    long messages =
        new ViewerRecording(
                recording, span, recording.channels(channels), channels.isEmpty(), everyS)
            .write(target, "u2sa " + ProgramVersion.text());
    say(target, Map.of("messages", messages));
  }

  private void ulog(RecordedMessages recording, RecordedSpan span) throws IOException {
    Path target = target(".ulg");
    long messages =
        new UlogRecording(recording, span, recording.channels(channels), everyS).write(target);
    say(target, Map.of("messages", messages));
  }

  private void map(RecordedMessages recording, RecordedSpan span) throws IOException {
    GeoRun run = GeoRun.read(recording, span, channels, everyS);
    String title = file.getFileName().toString();
    Path target = target("." + format);
    ReportFile.writeText(target, text -> write(text, title, run));
    Map<String, Long> counts = new LinkedHashMap<>();
    counts.put("tracks", (long) run.tracks().size());
    counts.put("points", (long) run.points());
    counts.put("goals", (long) run.goals().size());
    say(target, counts);
  }

  private void write(Writer text, String title, GeoRun run) throws IOException {
    switch (format) {
      case kml -> KmlText.write(text, title, run);
      case gpx -> GpxText.write(text, title, run);
      default -> GeoJsonText.write(text, run);
    }
  }
}
