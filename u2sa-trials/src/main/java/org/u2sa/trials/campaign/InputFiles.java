package org.u2sa.trials.campaign;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HexFormat;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.report.ReportFile;
import org.u2sa.world.sdf.SdfResources;

/**
 * The files that determine the results of a campaign's runs, with a digest of each: those that the
 * command names, the XML files beside them, the files that these name in turn, also in the folders
 * of Gazebo's environment variables, and U2SA's own configurations and missions. Files that runs
 * write do not count.
 */
final class InputFiles {
  private static final List<String> OWN = List.of("config", "missions");
  private static final int MAX_FILES = 10_000;
  private static final long MAX_TEXT_BYTES = 16L << 20; // larger ones name no files
  private static final int MAX_NAME = 300;
  private static final String MODEL = "model://";
  private static final String SERVER = "://";

  /** A variable that names a file which runs write, in a configuration. */
  private static final Pattern OUTPUT = Pattern.compile("<[^<>]*[\"']SAVE MAP[\"'][^<>]*>");

  /** The same, as an argument of {@code --set}. */
  private static final Pattern SET_OUTPUT = Pattern.compile("(.*=)?[^=]*:SAVE MAP=.*");

  /** An attribute's value, or the text of an element. */
  private static final Pattern VALUE =
      Pattern.compile("[\"']([^\"'<>\n]*)(?=[\"'])|>([^<>\n]*)(?=<)");

  private final Path excluded;
  private final SortedMap<String, String> digests = new TreeMap<>();
  private final Set<Path> seen = new TreeSet<>();
  private final Set<Path> folders = new TreeSet<>();
  private final Deque<Path> left = new ArrayDeque<>();

  private final List<Path> resources; // folders of Gazebo's models

  private InputFiles(Path excluded, List<Path> resources) {
    this.excluded = excluded.toAbsolutePath().normalize();
    this.resources = resources;
  }

  /**
   * Digests by file.
   *
   * @param words the command's words
   * @param home U2SA's folder
   * @param out the campaign's own folder, which is left out
   * @param environment variables of the process
   */
  static SortedMap<String, String> of(
      Collection<String> words, Path home, Path out, Map<String, String> environment) {
    InputFiles files = new InputFiles(out, SdfResources.folders(environment));
    try {
      for (String folder : OWN) {
        files.addAll(home.resolve(folder));
      }
      for (String word : words) {
        for (String name : names(word)) {
          files.add(Path.of(""), name);
        }
      }
      for (Path next = files.left.poll(); next != null; next = files.left.poll()) {
        files.visit(next);
      }
      return files.digests;
    } catch (IOException e) {
      throw new BadInputException("cannot read the campaign's files: " + ReportFile.reason(e), e);
    }
  }

  /** Digests of the class path, by entry. */
  static SortedMap<String, String> ofProgram(String classPath) {
    SortedMap<String, String> digests = new TreeMap<>();
    int number = 0;
    try {
      for (String entry : classPath.split(File.pathSeparator)) {
        MessageDigest digest = sha256();
        for (Path file : regularFiles(Path.of(entry))) {
          digest.update(
              Path.of(entry).relativize(file).toString().getBytes(StandardCharsets.UTF_8));
          digest(file, digest);
        }
        String name = "class path entry " + ++number + ", " + Path.of(entry).getFileName();
        digests.put(name, HexFormat.of().formatHex(digest.digest()));
      }
      return digests;
    } catch (IOException e) {
      throw new BadInputException("cannot read the class path: " + ReportFile.reason(e), e);
    }
  }

  /** A file of which the digests differ, or that only one of them has; empty if equal. */
  static Optional<String> difference(Map<String, String> one, Map<String, String> other) {
    Set<String> names = new TreeSet<>(one.keySet());
    names.addAll(other.keySet());
    return names.stream()
        .filter(name -> !one.getOrDefault(name, "").equals(other.getOrDefault(name, "")))
        .findFirst();
  }

  private static Set<String> names(String word) {
    if (SET_OUTPUT.matcher(word).matches()) {
      return Set.of();
    }
    Set<String> names = new LinkedHashSet<>(List.of(word));
    String value = word.substring(word.indexOf('=') + 1);
    names.add(value);
    names.addAll(List.of(value.split(",")));
    return names;
  }

  private void add(Path folder, String name) throws IOException {
    if (name.isBlank() || name.length() > MAX_NAME) {
      return;
    }
    try {
      if (name.startsWith(MODEL)) {
        addResource(folder, name.substring(MODEL.length()));
      } else if (name.contains(SERVER)) {
        addResource(folder, name.substring(name.lastIndexOf('/') + 1));
      } else if (Files.isRegularFile(folder.resolve(name.strip()))) {
        addAll(folder.resolve(name.strip()));
      } else {
        for (Path root : resources) {
          if (Files.isRegularFile(root.resolve(name.strip()))) {
            addAll(root.resolve(name.strip()));
          }
        }
      }
    } catch (InvalidPathException e) {
      // a value that is no file name
    }
  }

  /** Adds a model or mesh from wherever {@link SdfResources} looks for it. */
  private void addResource(Path folder, String name) throws IOException {
    if (name.isBlank() || name.startsWith(".")) {
      return;
    }
    for (String root : List.of("", "models", "../models")) {
      addAll(folder.resolve(root).resolve(name));
    }
    for (Path root : resources) {
      addAll(root.resolve(name));
    }
  }

  /** Adds a file, or all files of a folder. */
  private void addAll(Path path) throws IOException {
    for (Path file : regularFiles(path)) {
      Path absolute = file.toAbsolutePath().normalize();
      if (!absolute.startsWith(excluded) && seen.add(absolute)) {
        left.add(absolute);
      }
    }
    if (seen.size() > MAX_FILES) {
      throw new BadInputException(
          path + ": the campaign would depend on more than " + MAX_FILES + " files");
    }
  }

  private static List<Path> regularFiles(Path path) throws IOException {
    if (!Files.exists(path)) {
      return List.of();
    }
    try (Stream<Path> found = Files.walk(path)) {
      return found.filter(Files::isRegularFile).filter(Files::isReadable).sorted().toList();
    }
  }

  private void visit(Path file) throws IOException {
    MessageDigest digest = sha256();
    digest(file, digest);
    digests.put(shortName(file), HexFormat.of().formatHex(digest.digest()));
    if (folders.add(file.getParent()) && Files.isReadable(file.getParent())) {
      try (Stream<Path> beside = Files.list(file.getParent())) {
        for (Path other : beside.filter(InputFiles::isXml).sorted().toList()) {
          addAll(other);
        }
      }
    }
    if (Files.size(file) > MAX_TEXT_BYTES) {
      return;
    }
    String text = Files.readString(file, StandardCharsets.ISO_8859_1);
    Matcher values = VALUE.matcher(OUTPUT.matcher(text).replaceAll(""));
    while (values.find()) {
      add(file.getParent(), values.group(values.start(1) >= 0 ? 1 : 2));
    }
  }

  private static String shortName(Path file) {
    Path here = Path.of("").toAbsolutePath().normalize();
    return (file.startsWith(here) ? here.relativize(file) : file).toString();
  }

  private static boolean isXml(Path file) {
    return file.getFileName().toString().endsWith(".xml");
  }

  private static void digest(Path file, MessageDigest digest) throws IOException {
    try (InputStream in = new DigestInputStream(Files.newInputStream(file), digest)) {
      in.transferTo(OutputStream.nullOutputStream());
    }
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }
}
