package org.u2sa.interfaces;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The audit log of one configuration file: JSON lines in {@code <file>.audit.jsonl} beside it, so
 * that it moves, is backed up and is deleted with what it explains, and survives the logs of one
 * run. Nothing is ever removed from it but a last line that a power cut has torn: what that line
 * announced was not begun.
 */
final class AuditFile implements ChangeJournal {
  private static final String SUFFIX = ".audit.jsonl";

  /** How much of the file's end is read: some hundred changes. */
  private static final int TAIL_BYTES = 64 * 1024;

  private final Path configuration;

  /**
   * @param configuration the configuration file, which may be a link
   */
  AuditFile(Path configuration) {
    this.configuration = configuration;
  }

  /** The configuration file itself, behind links. */
  private Path target() throws IOException {
    return Files.exists(configuration)
        ? configuration.toRealPath()
        : configuration.toAbsolutePath();
  }

  private Path path() throws IOException {
    Path target = target();
    return target.resolveSibling(target.getFileName() + SUFFIX);
  }

  @Override
  public Turn take() throws IOException {
    FolderLock lock = FolderLock.take(target().getParent());
    return lock::close;
  }

  @Override
  public List<AuditEntry> recent() throws IOException {
    Path path = path();
    if (!Files.exists(path)) {
      return new ArrayList<>();
    }
    try (RandomAccessFile file = new RandomAccessFile(path.toFile(), "r")) {
      long length = file.length();
      for (long tail = TAIL_BYTES; true; tail *= 2) {
        long from = Math.max(0L, length - tail);
        List<AuditEntry> entries = entries(file, from, (int) (length - from));
        boolean enough =
            entries.stream().anyMatch(entry -> entry.outcome() == AuditEntry.Outcome.ACCEPTED);
        if (enough || from == 0) {
          return entries;
        }
      }
    }
  }

  private static List<AuditEntry> entries(RandomAccessFile file, long from, int length)
      throws IOException {
    byte[] bytes = new byte[length];
    file.seek(from);
    file.readFully(bytes);
    String[] lines = new String(bytes, StandardCharsets.UTF_8).split("\n");
    List<AuditEntry> entries = new ArrayList<>();
    for (int i = from == 0 ? 0 : 1;
        i < lines.length;
        i++) { // the first one is cut, unless it is it
      AuditLine.read(lines[i]).ifPresent(entries::add);
    }
    return entries;
  }

  @Override
  public void append(AuditEntry entry) throws IOException {
    byte[] line = (AuditLine.of(entry) + "\n").getBytes(StandardCharsets.UTF_8);
    Path path = path();
    boolean fresh = !Files.exists(path);
    try (RandomAccessFile file = new RandomAccessFile(path.toFile(), "rw")) {
      long end = endOfWholeLines(file);
      file.setLength(end);
      file.seek(end);
      try {
        file.write(line);
        file.getFD().sync();
      } catch (IOException e) {
        file.setLength(end);
        throw e;
      }
    } catch (FileNotFoundException e) {
      throw new IOException("the audit log cannot be written: " + e.getMessage(), e);
    }
    if (fresh) {
      WholeFile.sync(path.getParent());
    }
  }

  private static long endOfWholeLines(RandomAccessFile file) throws IOException {
    for (long end = file.length(); end > 0; end--) {
      file.seek(end - 1);
      if (file.read() == '\n') {
        return end;
      }
    }
    return 0;
  }
}
