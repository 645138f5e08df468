package org.u2sa.report.export;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.playback.RecordedMessages;
import org.u2sa.recorder.playback.RecordedSpan;

/**
 * Exports one table per topic of a recording (RFC 4180, UTF-8). Reads the recording twice: first to
 * determine the columns.
 */
public final class CsvTables {
  private static final String SUFFIX = ".csv";

  /** Code points of up to four bytes; file systems accept names of 255 bytes. */
  private static final int MAX_NAME = 55;

  private final RecordedMessages recording;
  private final RecordedSpan span;
  private final Predicate<McapChannel> wanted;
  private final double everyS;
  private final Map<Topic, CsvColumns> columns = new LinkedHashMap<>();

  /**
   * @param everyS minimum time between two rows of one source in a table [s]
   */
  public CsvTables(
      RecordedMessages recording, RecordedSpan span, Predicate<McapChannel> wanted, double everyS) {
    this.recording = recording;
    this.span = span;
    this.wanted = wanted;
    this.everyS = everyS;
  }

  /** Writes the tables to a folder; returns the files with their numbers of rows. */
  public Map<Path, Long> write(Path folder) throws IOException {
    forEach((topic, message, timeS) -> columnsOf(topic).learn(message));
    Files.createDirectories(folder);
    Map<Topic, Path> files = new LinkedHashMap<>();
    Map<Path, Long> rows = new LinkedHashMap<>();
    Map<String, Integer> namesakes = new HashMap<>(); // counts; may be tens of thousands
    try (CsvFiles texts = new CsvFiles()) {
      for (Map.Entry<Topic, CsvColumns> table : columns.entrySet()) {
        String name = name(table.getKey());
        Path file = folder.resolve(name + SUFFIX);
        while (rows.containsKey(file)) { // sources may differ only in non-letters
          file = folder.resolve(name + "-" + (1 + namesakes.merge(name, 1, Integer::sum)) + SUFFIX);
        }
        files.put(table.getKey(), file);
        rows.put(file, 0L);
        texts.write(file, table.getValue().head());
      }
      forEach(
          (topic, message, timeS) -> {
            Path file = files.get(topic);
            texts.write(file, columns.get(topic).row(timeS, message));
            rows.merge(file, 1L, Long::sum);
          });
    }
    return rows;
  }

  private CsvColumns columnsOf(Topic topic) {
    return columns.computeIfAbsent(topic, key -> new CsvColumns());
  }

  private interface Row {
    void take(Topic topic, U2SAData message, double timeS) throws IOException;
  }

  private void forEach(Row row) throws IOException {
    Spacing spacing = new Spacing(everyS);
    recording.forEach(
        wanted,
        span,
        (topic, message, nanos) -> {
          double timeS = span.seconds(nanos);
          if (spacing.takes(topic, message, timeS)) {
            row.take(topic, message, timeS);
          }
        });
  }

  /** Such as {@code sensed-state-StateInformation-gps}. */
  private static String name(Topic topic) {
    String type = topic.typeChain().get(topic.typeChain().size() - 1);
    String name =
        topic.channel() + "-" + type + (topic.source().isEmpty() ? "" : "-" + topic.source());
    return name.codePoints()
        .limit(MAX_NAME)
        .mapToObj(c -> Character.isLetterOrDigit(c) || c == '-' ? Character.toString(c) : "_")
        .collect(Collectors.joining());
  }
}
