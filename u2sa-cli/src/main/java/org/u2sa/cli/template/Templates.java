package org.u2sa.cli.template;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.ProviderNotFoundException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.NearestNames;

/**
 * The available templates: U2SA's own and an organisation's, which override them by name.
 *
 * <p>Each is a folder whose files are rendered into a project. A template with an {@code about.txt}
 * is a selectable kind; {@code project}, {@code maven} and {@code gradle} are shared by all new
 * projects.
 */
final class Templates implements AutoCloseable {
  static final String ABOUT = "about.txt";
  private static final String OURS = "U2SA";
  private static final int MAX_FILES = 500;
  private static final int MAX_BYTES = 4 << 20;

  /** A folder of templates, on disk or in a jar. */
  private record Source(String origin, Path root) {}

  record File(String origin, byte[] content) {}

  private final List<Source> sources = new ArrayList<>();
  private final List<FileSystem> jars = new ArrayList<>();

  /**
   * @param organisation folder or jar with templates that override those of U2SA
   * @throws BadInputException if it is neither
   */
  Templates(Optional<Path> organisation) {
    organisation.ifPresent(path -> sources.add(new Source(path.toString(), rootOf(path))));
    sources.add(new Source(OURS, ours()));
  }

  private Path rootOf(Path path) {
    if (Files.isDirectory(path)) {
      return path;
    }
    try {
      FileSystem jar = FileSystems.newFileSystem(path);
      jars.add(jar);
      return jar.getPath("/");
    } catch (IOException | ProviderNotFoundException e) {
      throw new BadInputException(
          "templates " + path + ": expected a folder or a jar (" + e.getMessage() + ")", e);
    }
  }

  private Path ours() {
    String one = "templates/sensor/" + ABOUT;
    URL url = Templates.class.getResource(one);
    if (url == null) {
      throw new IllegalStateException(one + " is missing next to " + Templates.class.getName());
    }
    try {
      if (url.getProtocol().equals("file")) {
        return Path.of(url.toURI()).getParent().getParent();
      }
      String[] jarAndEntry = url.toString().substring("jar:".length()).split("!", 2);
      return rootOf(Path.of(URI.create(jarAndEntry[0])))
          .resolve(jarAndEntry[1])
          .getParent()
          .getParent();
    } catch (URISyntaxException e) {
      throw new IllegalStateException(url + " is not a file location", e);
    }
  }

  Map<String, TemplateKind> kinds() {
    Map<String, TemplateKind> kinds = new TreeMap<>();
    for (Source source : sources) {
      try (Stream<Path> folders = Files.list(source.root)) {
        for (Path folder :
            folders.filter(each -> Files.isRegularFile(each.resolve(ABOUT))).toList()) {
          String name = folder.getFileName().toString().replace("/", "");
          String origin = source.origin + "/" + name + "/" + ABOUT;
          kinds.computeIfAbsent(
              name,
              absent ->
                  TemplateKind.read(name, source.origin, read(folder.resolve(ABOUT), origin)));
        }
      } catch (IOException e) {
        throw new BadInputException("templates " + source.origin + ": " + e.getMessage(), e);
      }
    }
    return kinds;
  }

  /**
   * The kind of that name.
   *
   * @throws BadInputException if not found; names the closest match
   */
  TemplateKind kind(String name) {
    Map<String, TemplateKind> kinds = kinds();
    TemplateKind kind = kinds.get(name);
    if (kind == null) {
      throw new BadInputException(
          String.format(
              "unknown kind \"%s\"; expected one of %s%s",
              name,
              String.join(", ", kinds.keySet()),
              NearestNames.didYouMean(name, kinds.keySet())));
    }
    return kind;
  }

  /**
   * Files of a template by relative path, without the about text.
   *
   * @throws BadInputException if there is no such template, or it is too large or malformed
   */
  Map<String, File> files(String template) {
    for (Source source : sources) {
      Path folder = source.root.resolve(template);
      if (Files.isDirectory(folder)) {
        return files(folder, source.origin + "/" + template);
      }
    }
    throw new BadInputException("missing template folder \"" + template + "\"");
  }

  private static Map<String, File> files(Path folder, String origin) {
    Map<String, File> files = new LinkedHashMap<>();
    int bytes = 0;
    try (Stream<Path> walk = Files.walk(folder)) {
      for (Path path :
          walk.filter(each -> !Files.isDirectory(each, LinkOption.NOFOLLOW_LINKS))
              .limit(MAX_FILES + 1)
              .toList()) {
        String place = folder.relativize(path).toString().replace('\\', '/');
        if (place.equals(ABOUT)) {
          continue;
        }
        byte[] content = read(path, origin + "/" + place);
        bytes += content.length;
        files.put(place, new File(origin + "/" + place, content));
        if (bytes > MAX_BYTES || files.size() > MAX_FILES) {
          throw new BadInputException(
              String.format(
                  "%s: expected at most %s files and %s bytes in total",
                  origin, MAX_FILES, MAX_BYTES));
        }
      }
    } catch (IOException e) {
      throw new BadInputException(origin + ": " + e.getMessage(), e);
    }
    return files;
  }

  private static byte[] read(Path path, String origin) {
    if (!Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS)) {
      throw new BadInputException(origin + ": expected a file, not a link or device");
    }
    try (InputStream in = Files.newInputStream(path)) {
      return in.readNBytes(MAX_BYTES + 1);
    } catch (IOException e) {
      throw new BadInputException(origin + ": " + e.getMessage(), e);
    }
  }

  @Override
  public void close() throws IOException {
    for (FileSystem jar : jars) {
      jar.close();
    }
  }

  /**
   * A selectable kind, as described by its {@code about.txt}: a line of description, an optional
   * line {@code with: …} that names templates whose files it also needs, and text to print at the
   * end.
   *
   * @param name name of its folder
   * @param origin location of the folder
   * @param description one-line description
   * @param with additional templates, whose files are shared within the project
   * @param advice how to run the result, with placeholders
   */
  record TemplateKind(
      String name, String origin, String description, List<String> with, String advice) {
    private static final String WITH = "with:";

    static TemplateKind read(String name, String origin, byte[] about) {
      List<String> lines = new String(about, StandardCharsets.UTF_8).lines().toList();
      if (lines.isEmpty() || lines.get(0).isBlank()) {
        throw new BadInputException(
            origin + "/" + name + "/" + Templates.ABOUT + ": expected a description in line 1");
      }
      boolean shares = lines.size() > 1 && lines.get(1).startsWith(WITH);
      List<String> with =
          shares
              ? Stream.of(lines.get(1).substring(WITH.length()).trim().split("[ ,]+")).toList()
              : List.of();
      String advice = String.join("\n", lines.subList(shares ? 2 : 1, lines.size())).strip();
      return new TemplateKind(name, origin, lines.get(0), with, advice);
    }
  }
}
