package org.u2sa.cli.record;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.record.McapMetadata;

/** Files of a split recording. */
final class RecordingParts {
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
