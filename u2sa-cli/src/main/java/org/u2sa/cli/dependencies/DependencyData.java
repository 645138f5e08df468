package org.u2sa.cli.dependencies;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.time.LocalDate;
import java.util.List;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Contents of libraries.txt and advisories.txt.
 *
 * @param lookedUp date of the last search for advisories
 */
record DependencyData(List<Library> libraries, List<Advisory> advisories, LocalDate lookedUp) {
  private static final Pattern LOOKED_UP =
      Pattern.compile("as looked up on (\\d{4}-\\d\\d-\\d\\d)");

  static DependencyData inThisJar() {
    String advisories = text("advisories.txt");
    Matcher lookedUp = LOOKED_UP.matcher(advisories);
    if (!lookedUp.find()) {
      throw new IllegalStateException("advisories.txt does not say when they were looked up");
    }
    return new DependencyData(
        rows(text("libraries.txt"), 5, DependencyData::library),
        rows(advisories, 6, DependencyData::advisory),
        LocalDate.parse(lookedUp.group(1)));
  }

  List<Advisory> affecting(Library library) {
    return advisories.stream().filter(advisory -> advisory.affects(library)).toList();
  }

  private static Library library(String[] cells) {
    return new Library(cells[0], cells[1], LocalDate.parse(cells[2]), cells[3], cells[4]);
  }

  private static Advisory advisory(String[] cells) {
    if (!cells[4].matches("yes|no")) {
      throw new IllegalStateException(cells[0] + ", reached: \"" + cells[4] + "\", not yes or no");
    }
    return new Advisory(cells[0], cells[1], cells[2], cells[3], cells[4].equals("yes"), cells[5]);
  }

  private static <T> List<T> rows(String text, int columns, Function<String[], T> read) {
    return text.lines()
        .filter(line -> !line.isBlank() && !line.startsWith("#"))
        .map(
            line -> {
              String[] cells = line.split(" \\| ");
              if (cells.length != columns) {
                throw new IllegalStateException(
                    "\"" + line + "\" has " + cells.length + " columns, expected " + columns);
              }
              return read.apply(cells);
            })
        .toList();
  }

  private static String text(String name) {
    try (InputStream in = DependencyData.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException("the jar has no " + name);
      }
      return new String(in.readAllBytes(), UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * A third-party library.
   *
   * @param name group:artifact
   * @param released release date of this version
   * @param use "run", "test", "android" or "build" (compile-time only)
   */
  record Library(String name, String version, LocalDate released, String use, String licence) {}

  /**
   * A published vulnerability.
   *
   * @param library group:artifact, or group:* for a whole group
   * @param introduced first affected version
   * @param fixed first fixed version, or "never"
   * @param reached whether our use of the library is affected
   */
  record Advisory(
      String id, String library, String introduced, String fixed, boolean reached, String what) {
    private static final String NEVER = "never";
    private static final String ALL = ":*";

    boolean affects(DependencyData.Library used) {
      boolean same =
          library.endsWith(ALL)
              ? used.name().startsWith(library.substring(0, library.length() - ALL.length() + 1))
              : used.name().equals(library);
      return same
          && compare(used.version(), introduced) >= 0
          && (fixed.equals(NEVER) || compare(used.version(), fixed) < 0);
    }

    /** Compares versions by numeric parts; words such as Final are ignored. */
    static int compare(String one, String other) {
      String[] left = one.split("[.-]");
      String[] right = other.split("[.-]");
      for (int i = 0; i < Math.max(left.length, right.length); i++) {
        int difference = Integer.compare(number(left, i), number(right, i));
        if (difference != 0) {
          return difference;
        }
      }
      return 0;
    }

    private static int number(String[] parts, int index) {
      return index < parts.length && parts[index].matches("\\d{1,9}")
          ? Integer.parseInt(parts[index])
          : 0;
    }
  }
}
