package org.u2sa.recorder;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapAttachment;
import org.u2sa.recorder.mcap.record.McapMetadata;

/**
 * Files of one recording: starts the next file when the current one is full, and deletes the oldest
 * beyond the configured number. Not thread-safe.
 *
 * <p>Survives a full or missing disk: what cannot be written is counted, and writing is retried
 * with the next chunk. If the current file was deleted or moved away, the next one is started,
 * recreating the folder if necessary.
 */
final class RecordingFiles {
  private static final String SUFFIX = ".mcap";
  private static final long TRY_AGAIN_NANOS = 1_000_000_000L;
  private static final long WORKS_AFTER_NANOS = 5_000_000_000L; // time without failures
  private static final int MAX_SAID = 8; // distinct failures logged until writing works again

  private final Disk disk;
  private final Path first;
  private final RecorderVariables settings;
  private final McapOptions options;
  private final RecordingFacts facts;
  private final Consumer<String> trouble;
  private final Deque<Path> written = new ArrayDeque<>();
  private int number;
  private McapWriter writer; // null if no file could be started
  private FileChannel channel; // confined to the writer thread
  private long begunNanos;
  private long tryAgainNanos = Long.MIN_VALUE;
  private long lost;
  private final Set<String> failures = new HashSet<>(); // logged so far; empty while writing works
  private long positionAtFailure; // in the current file [B]
  private long presentNanos;
  private long failedNanos;

  @FunctionalInterface
  interface Disk {
    FileChannel create(Path file) throws IOException;
  }

  /** Numbers the first file if it exists or more files follow. */
  RecordingFiles(
      Path first,
      RecorderVariables settings,
      String library,
      RecordingFacts facts,
      Consumer<String> trouble) {
    this(
        first,
        settings,
        library,
        facts,
        trouble,
        file -> FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE));
  }

  RecordingFiles(
      Path first,
      RecorderVariables settings,
      String library,
      RecordingFacts facts,
      Consumer<String> trouble,
      Disk disk) {
    this.disk = disk;
    this.first = first;
    this.settings = settings;
    options = McapOptions.usual(settings.compression(), library);
    this.facts = facts;
    this.trouble = trouble;
  }

  /** Writer for messages of a time, or null; calls {@code onBegin} after starting another file. */
  McapWriter at(long nanos, Runnable onBegin) {
    presentNanos = nanos;
    if (writer != null && isFull(nanos)) {
      end(nanos, Map.of());
    }
    if (writer == null && nanos >= tryAgainNanos) {
      begin(nanos);
      if (writer != null) {
        onBegin.run();
      }
    }
    if (!failures.isEmpty()
        && writer != null
        && writer.position() > positionAtFailure
        && nanos - failedNanos >= WORKS_AFTER_NANOS) {
      failures.clear();
      trouble.accept(
          "recording into " + file() + ": recording again; messages in between are lost");
    }
    return writer;
  }

  private boolean isFull(long nanos) {
    return writer.position() >= settings.splitBytes()
        || Math.abs(nanos - begunNanos) >= settings.splitNanos(); // clocks may also jump back
  }

  private void begin(long nanos) {
    try {
      Files.createDirectories(first.toAbsolutePath().getParent());
      Path file = nextName();
      channel = disk.create(file);
      try {
        writer = new McapWriter(channel, options);
      } catch (IOException e) {
        discard(file, e);
        throw e;
      }
      written.add(file);
      begunNanos = nanos;
    } catch (IOException e) {
      number = Math.max(0, number - 1);
      tryAgainNanos = nanos + TRY_AGAIN_NANOS;
      failed(e);
      makeRoom();
      return;
    }
    try {
      dropOldest();
      for (McapMetadata metadata : facts.metadata()) {
        writer.add(metadata);
      }
      List<RecordingFacts.Missing> missing = new ArrayList<>();
      attach(facts.attachments(nanos, missing), missing);
    } catch (IOException e) {
      failed(e);
    }
  }

  private void discard(Path file, IOException cause) {
    try {
      channel.close();
      Files.deleteIfExists(file);
    } catch (IOException e) {
      cause.addSuppressed(e);
    }
  }

  /**
   * Deletes the oldest file if the limit is reached, but never the only one: it may be what fills
   * the disk.
   */
  private void makeRoom() {
    if (written.size() > 1
        && settings.keptAtMost().isPresent()
        && written.size() >= settings.keptAtMost().getAsInt()) {
      try {
        Files.deleteIfExists(written.peek());
        written.remove();
      } catch (IOException e) {
        failed(e);
      }
    }
  }

  private void dropOldest() throws IOException {
    while (settings.keptAtMost().isPresent() && written.size() > settings.keptAtMost().getAsInt()) {
      Files.deleteIfExists(written.poll());
    }
  }

  private Path nextName() {
    String name = first.getFileName().toString();
    String stem = name.endsWith(SUFFIX) ? name.substring(0, name.length() - SUFFIX.length()) : name;
    Path file;
    do {
      number++;
      String numbered =
          settings.splits()
              ? String.format(Locale.ROOT, "%s-%04d%s", stem, number, SUFFIX)
              : stem + (number == 1 ? "" : "-" + number) + SUFFIX;
      file = first.resolveSibling(numbered);
    } while (Files.exists(file));
    return file;
  }

  private void attach(List<McapAttachment> attachments, List<RecordingFacts.Missing> missing)
      throws IOException {
    for (McapAttachment attachment : attachments) {
      writer.add(attachment);
    }
    if (!missing.isEmpty()) {
      Map<String, String> why = new LinkedHashMap<>();
      missing.forEach(one -> why.put(one.name(), one.why()));
      writer.add(new McapMetadata("not-attached", why));
    }
  }

  /**
   * Writes the current chunk, so that it survives if the program is killed, and syncs it to disk.
   */
  void save(DiskSync sync) {
    if (writer != null) {
      try {
        writer.flush();
        sync.ask(channel);
      } catch (IOException e) {
        failed(e);
      }
    }
  }

  /** Completes the current file with the recorder's counters so far. */
  void end(long nanos, Map<String, String> counts) {
    if (writer == null) {
      return;
    }
    McapWriter ended = writer;
    try {
      ended.flush();
    } catch (IOException e) { // there may be room for the rest
      failed(e);
    }
    try {
      if (!counts.isEmpty()) {
        ended.add(new McapMetadata("recorder", counts));
        List<RecordingFacts.Missing> missing = new ArrayList<>();
        attach(facts.attachmentsOfEnd(nanos, missing), missing);
      }
    } catch (IOException e) {
      failed(e);
    }
    try {
      ended.close();
    } catch (IOException e) {
      failed(e);
    }
    lost += ended.lost();
    writer = null;
  }

  /**
   * Starts the next file if the current one was deleted or moved away, since further writes to it
   * would be lost.
   */
  void requirePresent(long nanos) {
    if (writer == null || Files.exists(file())) {
      return;
    }
    trouble.accept(
        "recording into "
            + file()
            + ": the file was deleted or moved away, with "
            + writer.statistics().messages()
            + " messages; recording continues in another file");
    written.removeLast();
    end(nanos, Map.of());
  }

  /** Counts a failed write; logs each distinct failure once until writing works again. */
  void failed(IOException e) {
    positionAtFailure = writer == null ? 0 : writer.position();
    failedNanos = presentNanos;
    String what =
        e instanceof FileSystemException
            ? e.getClass().getSimpleName() + " " + e.getMessage() // message is only the name
            : String.valueOf(e.getMessage());
    if (failures.size() < MAX_SAID && failures.add(what)) { // must not flood the log
      trouble.accept("recording into " + file() + ": " + what + "; retrying until it works");
    }
  }

  private Path file() {
    return written.isEmpty() ? first : written.peekLast();
  }

  /** Number of accepted messages that could not be written. */
  long lost() {
    return lost + (writer == null ? 0 : writer.lost());
  }

  /** Files of the recording, oldest first, without deleted ones. */
  List<Path> written() {
    return List.copyOf(written);
  }
}
