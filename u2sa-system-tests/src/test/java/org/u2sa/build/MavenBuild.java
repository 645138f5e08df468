package org.u2sa.build;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.xml.sax.SAXException;

/** Reads the reactor: the root's pom.xml and those of its modules. */
final class MavenBuild {
  private static final Pattern PROPERTY = Pattern.compile("\\$\\{([^}]+)}");
  private static final String BOM = "u2sa-bom";
  private static final String ANDROID = "org.robolectric:android-all";

  private final Path folder;
  private final Element root;
  private final Map<String, String> properties = new HashMap<>();
  private final Map<String, Element> managed = new HashMap<>();

  private MavenBuild(Path folder) throws IOException {
    this.folder = folder;
    root = parse(folder.resolve("pom.xml"));
    properties.put("project.version", text(root, "version"));
    for (Element property : children(only(root, "properties"))) {
      properties.put(property.getTagName(), property.getTextContent().trim());
    }
    for (Element dependency : dependencies(only(root, "dependencyManagement"))) {
      managed.put(name(dependency), dependency);
    }
  }

  static BuildDescription read(Path folder) throws IOException {
    return new MavenBuild(folder).describe();
  }

  private BuildDescription describe() throws IOException {
    SortedMap<String, SortedSet<Dependency>> modules = new TreeMap<>();
    SortedSet<String> bom = new TreeSet<>();
    SortedMap<String, String> settings = settings();
    for (Element module : children(only(root, "modules"))) {
      String name = module.getTextContent().trim();
      Element pom = parse(folder.resolve(name).resolve("pom.xml"));
      if (name.equals(BOM)) {
        requireVersion(name, text(pom, "version"));
        dependencies(only(pom, "dependencyManagement"))
            .forEach(dependency -> bom.add(listed(dependency)));
        modules.put(name, new TreeSet<>());
      } else {
        requireVersion(name, text(only(pom, "parent"), "version"));
        modules.put(name, declared(pom));
        testProperties(pom)
            .forEach((key, value) -> settings.put("test property of " + name + ", " + key, value));
      }
    }
    return new BuildDescription(settings, versions(), bom, declared(root), modules);
  }

  private SortedMap<String, String> settings() {
    SortedMap<String, String> settings = new TreeMap<>();
    settings.put("group", text(root, "groupId"));
    settings.put("version", text(root, "version"));
    settings.put("Java release", properties.get("maven.compiler.release"));
    settings.put("excluded tags", properties.get("u2sa.excluded.tags"));
    settings.put("test JVM", properties.get("u2sa.test.jvm"));
    SortedSet<String> arguments = new TreeSet<>();
    SortedSet<String> testClasses = new TreeSet<>();
    Element management = only(only(root, "build"), "pluginManagement");
    for (Element plugin : children(only(management, "plugins"))) {
      if (text(plugin, "artifactId").equals("maven-compiler-plugin")) {
        Element configuration = only(plugin, "configuration");
        children(only(configuration, "compilerArgs"))
            .forEach(argument -> arguments.add(argument.getTextContent().trim()));
        if (Boolean.parseBoolean(text(configuration, "parameters"))) {
          arguments.add("-parameters");
        }
      }
      if (text(plugin, "artifactId").equals("maven-surefire-plugin")) {
        children(only(only(plugin, "configuration"), "includes"))
            .forEach(name -> testClasses.add(name.getTextContent().trim().replace(".java", "")));
      }
    }
    settings.put("test classes", testClasses.toString());
    settings.put("compiler arguments", arguments.toString());
    return settings;
  }

  /** System properties that Surefire gives to the module's tests, without those of profiles. */
  private static SortedMap<String, String> testProperties(Element pom) {
    SortedMap<String, String> found = new TreeMap<>();
    descend(List.of(pom), "build", "plugins", "plugin").stream()
        .filter(plugin -> text(plugin, "artifactId").equals("maven-surefire-plugin"))
        .flatMap(
            plugin -> descend(List.of(plugin), "configuration", "systemPropertyVariables").stream())
        .flatMap(list -> children(list).stream())
        .forEach(property -> found.put(property.getTagName(), property.getTextContent().trim()));
    return found;
  }

  private static List<Element> descend(List<Element> from, String... names) {
    List<Element> reached = from;
    for (String name : names) {
      reached = reached.stream().flatMap(element -> named(element, name).stream()).toList();
    }
    return reached;
  }

  private SortedMap<String, String> versions() {
    SortedMap<String, String> versions = new TreeMap<>();
    managed.forEach(
        (name, dependency) -> {
          if (!text(dependency, "groupId").equals(text(root, "groupId"))) {
            versions.put(name, resolved(text(dependency, "version")));
          }
        });
    return versions;
  }

  private SortedSet<Dependency> declared(Element pom) {
    SortedSet<Dependency> declared = new TreeSet<>();
    for (Element dependency : dependencies(pom)) {
      String name = name(dependency);
      if (name.equals(ANDROID)) {
        continue; // the platform itself: Gradle has it from the Android SDK
      }
      Optional<Element> management = Optional.ofNullable(managed.get(name));
      String version =
          optional(dependency, "version")
              .or(() -> management.flatMap(element -> optional(element, "version")))
              .orElseThrow(() -> new IllegalStateException(name + " has no version"));
      SortedSet<String> exclusions = exclusions(dependency);
      management.ifPresent(element -> exclusions.addAll(exclusions(element)));
      Dependency.Scope scope =
          Dependency.Scope.valueOf(optional(dependency, "scope").orElse("compile").toUpperCase());
      declared.add(new Dependency(name, resolved(version), scope, exclusions));
    }
    return declared;
  }

  private void requireVersion(String module, String version) {
    if (!version.equals(text(root, "version"))) {
      throw new IllegalStateException(
          module + "/pom.xml says version " + version + ", expected " + text(root, "version"));
    }
  }

  private String resolved(String value) {
    Matcher matcher = PROPERTY.matcher(value);
    return matcher.replaceAll(
        match -> {
          String found = properties.get(match.group(1));
          if (found == null) {
            throw new IllegalStateException("pom.xml has no property " + match.group(1));
          }
          return Matcher.quoteReplacement(found);
        });
  }

  private static SortedSet<String> exclusions(Element dependency) {
    SortedSet<String> exclusions = new TreeSet<>();
    for (Element list : named(dependency, "exclusions")) {
      for (Element exclusion : children(list)) {
        String artifact = text(exclusion, "artifactId");
        exclusions.add(text(exclusion, "groupId") + (artifact.equals("*") ? "" : ":" + artifact));
      }
    }
    return exclusions;
  }

  /** A module as the BOM lists it; a jar with a classifier is found by its type only. */
  private static String listed(Element dependency) {
    return Stream.concat(
            Stream.of(text(dependency, "artifactId")),
            Stream.of("type", "classifier").flatMap(name -> optional(dependency, name).stream()))
        .collect(Collectors.joining(":"));
  }

  private static String name(Element dependency) {
    String name = text(dependency, "groupId") + ":" + text(dependency, "artifactId");
    return name + optional(dependency, "classifier").map(text -> ":" + text).orElse("");
  }

  private static List<Element> dependencies(Element parent) {
    List<Element> found = new ArrayList<>();
    named(parent, "dependencies").forEach(list -> found.addAll(children(list)));
    return found;
  }

  private static Element only(Element parent, String name) {
    List<Element> found = named(parent, name);
    if (found.size() != 1) {
      throw new IllegalStateException(
          "<" + parent.getTagName() + "> has " + found.size() + " <" + name + ">, expected one");
    }
    return found.get(0);
  }

  private static String text(Element parent, String name) {
    return only(parent, name).getTextContent().trim();
  }

  private static Optional<String> optional(Element parent, String name) {
    return named(parent, name).stream().findFirst().map(found -> found.getTextContent().trim());
  }

  private static List<Element> named(Element parent, String name) {
    return children(parent).stream().filter(child -> child.getTagName().equals(name)).toList();
  }

  private static List<Element> children(Element parent) {
    List<Element> children = new ArrayList<>();
    for (Node node = parent.getFirstChild(); node != null; node = node.getNextSibling()) {
      if (node instanceof Element element) {
        children.add(element);
      }
    }
    return children;
  }

  private static Element parse(Path file) throws IOException {
    try {
      return DocumentBuilderFactory.newDefaultInstance()
          .newDocumentBuilder()
          .parse(file.toFile())
          .getDocumentElement();
    } catch (ParserConfigurationException | SAXException e) {
      throw new IOException(file + " is no XML: " + e.getMessage(), e);
    }
  }
}
