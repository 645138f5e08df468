package org.u2sa.cli.template;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.u2sa.interfaces.BadInputException;

/**
 * Adds files to a project, all or none: they are written to a temporary folder next to their
 * destination and then moved. Existing files are not overwritten; only lists in {@code
 * META-INF/services} are extended.
 */
final class Destination {
  private static final String LISTS = "META-INF/services/";

  private final Path folder;

  Destination(Path folder) {
    this.folder = folder.toAbsolutePath().normalize();
  }

  /**
   * Creates the folder with these files.
   *
   * @throws BadInputException if it exists or cannot be written
   */
  List<String> create(SortedMap<String, byte[]> files) {
    if (Files.exists(folder, LinkOption.NOFOLLOW_LINKS)) {
      throw new BadInputException(
          folder
              + " exists; expected the name of a new project, or --into with the folder of an "
              + "existing one");
    }
    Path draft = folder.resolveSibling("." + folder.getFileName() + ".new");
    writing(
        draft,
        () -> {
          write(draft, files);
          Files.move(draft, folder);
        });
    return List.copyOf(files.keySet());
  }

  /**
   * Adds the files to the project in the folder.
   *
   * @param shared paths of files that are kept if they exist
   * @return paths of new and changed files
   * @throws BadInputException if another file exists, or one cannot be written
   */
  List<String> add(SortedMap<String, byte[]> files, Set<String> shared) {
    Path draft = folder.resolve(".u2sa.new");
    SortedMap<String, byte[]> wanted = new TreeMap<>();
    writing(
        draft,
        () -> {
          for (Map.Entry<String, byte[]> file : files.entrySet()) {
            Path target = inside(folder, file.getKey());
            boolean exists = Files.exists(target, LinkOption.NOFOLLOW_LINKS);
            if (!exists) {
              wanted.put(file.getKey(), file.getValue());
            } else if (file.getKey().contains(LISTS)) {
              wanted.put(file.getKey(), merged(target, file.getValue()));
            } else if (!shared.contains(file.getKey())) {
              throw new BadInputException(target + " exists; expected another name or project");
            }
          }
          write(draft, wanted);
          move(draft, wanted);
        });
    return List.copyOf(wanted.keySet());
  }

  private static byte[] merged(Path list, byte[] more) throws IOException {
    Set<String> lines = new LinkedHashSet<>(Files.readAllLines(list));
    new String(more, StandardCharsets.UTF_8).lines().forEach(lines::add);
    return (String.join("\n", lines) + "\n").getBytes(StandardCharsets.UTF_8);
  }

  private static void write(Path draft, SortedMap<String, byte[]> files) throws IOException {
    Files.createDirectory(draft);
    for (Map.Entry<String, byte[]> file : files.entrySet()) {
      Path target = inside(draft, file.getKey());
      Files.createDirectories(target.getParent());
      Files.write(target, file.getValue());
      if (isScript(file.getValue()) && !target.toFile().setExecutable(true)) {
        throw new IOException(target + " cannot be made executable");
      }
    }
  }

  private static boolean isScript(byte[] content) {
    return content.length > 1 && content[0] == '#' && content[1] == '!';
  }

  private void move(Path draft, SortedMap<String, byte[]> files) throws IOException {
    Deque<Path> made = new ArrayDeque<>();
    try {
      for (String place : files.keySet()) {
        Path target = folder.resolve(place);
        for (Path missing : missing(target.getParent())) {
          Files.createDirectory(missing);
          made.push(missing);
        }
        if (place.contains(LISTS)) {
          continue; // last, because these changes cannot be undone
        }
        Files.move(draft.resolve(place), target);
        made.push(target);
      }
      for (String place : files.keySet()) {
        if (place.contains(LISTS)) {
          Files.move(
              draft.resolve(place), folder.resolve(place), StandardCopyOption.REPLACE_EXISTING);
        }
      }
    } catch (IOException e) {
      for (Path each : made) {
        Files.delete(each);
      }
      throw e;
    }
  }

  private static List<Path> missing(Path directory) {
    Deque<Path> missing = new ArrayDeque<>();
    for (Path each = directory; !Files.exists(each); each = each.getParent()) {
      missing.push(each);
    }
    return new ArrayList<>(missing);
  }

  /** Resolves a path in the folder, unless its name or a link leads out of it. */
  private static Path inside(Path folder, String place) throws IOException {
    Path target = folder.resolve(place).normalize();
    Path existing = target.getParent();
    while (!Files.exists(existing)) {
      existing = existing.getParent();
    }
    boolean leaves = !target.startsWith(folder) || target.equals(folder);
    if (leaves || !existing.toRealPath().startsWith(folder.toRealPath())) {
      throw new BadInputException(
          "\"" + place + "\" leads out of " + folder + "; expected a path inside it");
    }
    return target;
  }

  private interface Writing {
    void run() throws IOException;
  }

  private static void writing(Path draft, Writing writing) {
    if (Files.exists(draft, LinkOption.NOFOLLOW_LINKS)) {
      throw new BadInputException(
          draft + " exists: is another u2sa new running? If one was killed, remove it");
    }
    try {
      try {
        writing.run();
      } finally {
        remove(draft);
      }
    } catch (IOException e) {
      throw new BadInputException(
          "cannot write " + e.getMessage() + " (" + e.getClass().getSimpleName() + ")", e);
    }
  }

  private static void remove(Path draft) throws IOException {
    if (Files.exists(draft)) {
      try (Stream<Path> all = Files.walk(draft)) {
        for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(each);
        }
      }
    }
  }
}
