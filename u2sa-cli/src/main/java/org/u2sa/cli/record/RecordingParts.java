package org.u2sa.cli.record;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.record.McapMetadata;

/** Files of a split recording. */
public final class RecordingParts {
  private static final Pattern NUMBERED = Pattern.compile("(.*-)(\\d{4,9})\\.mcap");

  private RecordingParts() {}

  /**
   * Finds the consecutively numbered files of one recording: they have the same run and host
   * metadata, and each starts after the previous one ended.
   *
   * @throws BadInputException if there is no such file
   * @throws IOException if one cannot be read
   */
  static List<Path> beginningWith(Path file) throws IOException {
    RegularFile.require(file, "a recording (MCAP)");
    List<Path> parts = new ArrayList<>(List.of(file));
    Optional<Path> next = neighbour(file, 1);
    while (next.isPresent() && follows(next.get(), parts.get(parts.size() - 1))) {
      parts.add(next.get());
      next = neighbour(next.get(), 1);
    }
    return parts;
  }

  /** Earlier files of the same recording, in order. */
  private static List<Path> before(Path file) throws IOException {
    List<Path> parts = new ArrayList<>();
    Path first = file;
    Optional<Path> previous = neighbour(file, -1);
    while (previous.isPresent() && follows(first, previous.get())) {
      first = previous.get();
      parts.add(0, first);
      previous = neighbour(first, -1);
    }
    return parts;
  }

  /** The file whose number differs by this much, if it exists. */
  private static Optional<Path> neighbour(Path file, int by) {
    Matcher name = NUMBERED.matcher(file.getFileName().toString());
    if (!name.matches()) {
      return Optional.empty();
    }
    int number = Integer.parseInt(name.group(2)) + by;
    return Optional.of(
            file.resolveSibling(String.format(Locale.ROOT, "%s%04d.mcap", name.group(1), number)))
        .filter(Files::isRegularFile);
  }

  /** Note for a command that reads one file only; empty if it is the whole recording. */
  public static Optional<String> othersNotRead(Path file) {
    List<Path> others = new ArrayList<>();
    try {
      others.addAll(before(file));
      List<Path> parts = beginningWith(file);
      others.addAll(parts.subList(1, parts.size()));
    } catch (IOException e) {
      return Optional.empty(); // the error concerns another file
    }
    return others.isEmpty()
        ? Optional.empty()
        : Optional.of(
            String.format(
                "%s is part of a split recording; not read: %s",
                file,
                others.size() == 1
                    ? others.get(0)
                    : String.format(
                        "%d more files, %s to %s",
                        others.size(), others.get(0), others.get(others.size() - 1))));
  }

  private static boolean follows(Path next, Path before) throws IOException {
    try (McapReader later = McapReader.open(next);
        McapReader earlier = McapReader.open(before)) {
      return facts(later).equals(facts(earlier))
          && later.statistics().startNanos() >= earlier.statistics().endNanos();
    }
  }

  private static List<McapMetadata> facts(McapReader reader) throws IOException {
    return reader.metadata().stream()
        .filter(metadata -> List.of("run", "host").contains(metadata.name()))
        .collect(Collectors.toList());
  }
}
