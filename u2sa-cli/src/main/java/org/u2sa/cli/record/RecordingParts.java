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
    if (!Files.isRegularFile(file)) {
      throw new BadInputException(file + ": no such file; expected a recording (MCAP)");
    }
    List<Path> parts = new ArrayList<>(List.of(file));
    Matcher name = NUMBERED.matcher(file.getFileName().toString());
    if (name.matches()) {
      int number = Integer.parseInt(name.group(2));
      Path next = file;
      do {
        if (next != file) {
          parts.add(next);
        }
        number++;
        next =
            file.resolveSibling(String.format(Locale.ROOT, "%s%04d.mcap", name.group(1), number));
      } while (Files.isRegularFile(next) && follows(next, parts.get(parts.size() - 1)));
    }
    return parts;
  }

  /** Remark for a command that reads one file only; empty if no other one continues it. */
  public static Optional<String> othersNotRead(Path file) {
    List<Path> parts;
    try {
      parts = beginningWith(file);
    } catch (IOException e) {
      return Optional.empty(); // of the next file; the command reads only this one
    }
    int others = parts.size() - 1;
    return others == 0
        ? Optional.empty()
        : Optional.of(
            String.format(
                "%s is part of a split recording; not read: %s",
                file,
                others == 1
                    ? parts.get(1)
                    : others + " more files, " + parts.get(1) + " to " + parts.get(others)));
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
