package org.u2sa.report.export;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.report.ReportFile;

/**
 * Text files written alternately, with only some open at a time: a recording may have more topics
 * than the system's limit of open files. Not thread-safe.
 */
final class CsvFiles implements AutoCloseable {
  private static final int MAX_OPEN = 256;

  private final Map<Path, Writer> open =
      new LinkedHashMap<>(16, 0.75f, true); // least recently used first
  private final Set<Path> begun = new HashSet<>();
  private final Opener opener;

  @FunctionalInterface
  interface Opener {
    Writer open(Path file, OpenOption... how) throws IOException;
  }

  CsvFiles() {
    this(CsvFiles::opened);
  }

  CsvFiles(Opener opener) {
    this.opener = opener;
  }

  private static Writer opened(Path file, OpenOption... how) throws IOException {
    OutputStream out =
        how.length == 0 ? ReportFile.newOutputStream(file) : Files.newOutputStream(file, how);
    return new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
  }

  /**
   * Appends text to a file, which is created at the first call in place of one of that name, or of
   * a link.
   *
   * @throws RunFailedException if a file cannot be written
   */
  void write(Path file, String text) {
    try {
      append(file, text);
    } catch (IOException e) {
      throw ReportFile.notWritten(file, e);
    }
  }

  private void append(Path file, String text) throws IOException {
    Writer writer = open.get(file);
    if (writer == null) {
      makeRoom();
      writer =
          begun.add(file)
              ? opener.open(file)
              : opener.open(
                  file,
                  StandardOpenOption.WRITE,
                  StandardOpenOption.APPEND,
                  LinkOption.NOFOLLOW_LINKS);
      open.put(file, writer);
    }
    writer.write(text);
  }

  private void makeRoom() {
    if (open.size() >= MAX_OPEN) {
      Iterator<Map.Entry<Path, Writer>> oldest = open.entrySet().iterator();
      Map.Entry<Path, Writer> ended = oldest.next();
      oldest.remove();
      end(ended.getKey(), ended.getValue());
    }
  }

  private static void end(Path file, Writer writer) {
    try {
      writer.close();
    } catch (IOException e) {
      throw ReportFile.notWritten(file, e);
    }
  }

  /** Closes all files; reports the last one that could not be written. */
  @Override
  public void close() {
    RunFailedException failure = null;
    for (Map.Entry<Path, Writer> each : open.entrySet()) {
      try {
        end(each.getKey(), each.getValue());
      } catch (RunFailedException e) {
        failure = e;
      }
    }
    if (failure != null) {
      throw failure;
    }
  }
}
