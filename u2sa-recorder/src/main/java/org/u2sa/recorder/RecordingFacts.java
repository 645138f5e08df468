package org.u2sa.recorder;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import org.u2sa.recorder.mcap.record.McapAttachment;
import org.u2sa.recorder.mcap.record.McapMetadata;

/**
 * Metadata of a run in its recording: named texts and attached files. Filled before recording
 * starts.
 */
public final class RecordingFacts {
  private static final long LARGEST_ATTACHMENT = 16L << 20;

  private final Map<String, Map<String, String>> metadata = new LinkedHashMap<>();
  private final Map<String, Path> files = new LinkedHashMap<>();
  private Supplier<Map<String, Path>> filesOfEnd = Map::of;

  /** A file that could not be attached. */
  record Missing(String name, String why) {}

  /** Adds a text, for example {@code ("run", "seed", "1")}. */
  public RecordingFacts say(String about, String name, String text) {
    metadata.computeIfAbsent(about, key -> new LinkedHashMap<>()).put(name, text);
    return this;
  }

  /** Attaches a file at the beginning of each file of the recording. */
  public RecordingFacts attach(String name, Path file) {
    files.put(name, file);
    return this;
  }

  /**
   * Sets which files are attached when the recording ends, such as logs.
   *
   * @param byName called when the recording ends
   */
  public RecordingFacts attachAtEnd(Supplier<Map<String, Path>> byName) {
    filesOfEnd = byName;
    return this;
  }

  List<McapMetadata> metadata() {
    List<McapMetadata> all = new ArrayList<>();
    metadata.forEach((about, texts) -> all.add(new McapMetadata(about, texts)));
    return all;
  }

  List<McapAttachment> attachments(long logTimeNanos, List<Missing> missing) {
    return read(files, logTimeNanos, missing);
  }

  List<McapAttachment> attachmentsOfEnd(long logTimeNanos, List<Missing> missing) {
    return read(filesOfEnd.get(), logTimeNanos, missing);
  }

  private static List<McapAttachment> read(
      Map<String, Path> files, long logTimeNanos, List<Missing> missing) {
    List<McapAttachment> all = new ArrayList<>();
    files.forEach(
        (name, file) -> {
          try {
            long size = Files.size(file);
            if (size > LARGEST_ATTACHMENT) {
              missing.add(new Missing(name, size + " bytes: more than 16 MiB"));
              return;
            }
            all.add(
                new McapAttachment(
                    logTimeNanos, 0, name, mediaType(name), Files.readAllBytes(file)));
          } catch (IOException e) {
            missing.add(new Missing(name, e.toString()));
          }
        });
    return all;
  }

  private static String mediaType(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    if (lower.endsWith(".xml")) {
      return "text/xml";
    }
    if (lower.endsWith(".json")) {
      return "application/json";
    }
    return "text/plain";
  }
}
