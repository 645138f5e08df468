package org.u2sa.cli.look;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Reads the logs of a folder and follows them as they grow. */
final class LogFolder {
  private static final String ENDING = ".log";
  private static final int DEPTH = 3; // out/RUN/logs

  private final Path folder;
  private final Map<Path, Long> readUpTo = new HashMap<>();

  LogFolder(Path folder) {
    this.folder = folder;
  }

  /** Most recently written log folder below the given one. */
  static Optional<Path> newestBelow(Path base) throws IOException {
    if (!Files.isDirectory(base)) {
      return Optional.empty();
    }
    try (Stream<Path> files = Files.walk(base, DEPTH)) {
      return files
          .filter(LogFolder::isLog)
          .max(Comparator.comparingLong(file -> file.toFile().lastModified()))
          .map(Path::getParent);
    }
  }

  private static boolean isLog(Path file) {
    return file.getFileName().toString().endsWith(ENDING) && Files.isRegularFile(file);
  }

  /** Entries written since the last call, sorted by time. */
  List<LogLine> more() throws IOException {
    List<LogLine> lines = new ArrayList<>();
    for (Path file : logs()) {
      lines.addAll(LogLine.of(grown(file)));
    }
    lines.sort(Comparator.comparing(LogLine::time));
    return lines;
  }

  private List<Path> logs() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(LogFolder::isLog).sorted().collect(Collectors.toList());
    }
  }

  /**
   * Reads complete lines only; an incomplete one is read later. A file that has shrunk was
   * restarted.
   */
  private String grown(Path file) throws IOException {
    try (RandomAccessFile in = new RandomAccessFile(file.toFile(), "r")) {
      long from = readUpTo.getOrDefault(file, 0L);
      from = in.length() < from ? 0 : from;
      byte[] bytes = new byte[(int) Math.min(in.length() - from, Integer.MAX_VALUE - 8)];
      in.seek(from);
      in.readFully(bytes);
      int end = bytes.length;
      while (end > 0 && bytes[end - 1] != '\n') {
        end--;
      }
      readUpTo.put(file, from + end);
      return new String(bytes, 0, end, StandardCharsets.UTF_8);
    }
  }
}
