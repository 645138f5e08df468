package org.u2sa.interfaces.configuration;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlText;

/**
 * The configuration file of one service as it stands on the disk at one moment, or is to stand.
 * Immutable.
 */
final class ConfigurationFile {
  private static final String ROOT = "configuration";

  private final Path path;
  private final XmlText text;
  private final XmlElement root;
  private final Map<String, XmlElement> elements = new LinkedHashMap<>();
  private final Map<String, FileVariable> variables = new LinkedHashMap<>();

  private ConfigurationFile(Path path, XmlText text) {
    this.path = path;
    this.text = text;
    root = text.root(ROOT);
    root.refuseUnknownAttributes();
    root.refuseText();
    root.refuseUnknownChildren(FileVariable.ELEMENT);
    for (XmlElement element : root.children()) {
      FileVariable variable = FileVariable.of(element);
      XmlElement first = elements.putIfAbsent(variable.name(), element);
      if (first != null) {
        throw variable.error("stands twice; it stands in line " + first.line() + " already");
      }
      variables.put(variable.name(), variable);
    }
  }

  /**
   * Reads the file.
   *
   * @throws ConfigurationException if it cannot be used; names file, line and what was expected
   */
  static ConfigurationFile read(Path path) {
    try {
      return new ConfigurationFile(path, XmlText.read(path));
    } catch (ConfigurationException e) {
      throw e;
    } catch (BadInputException e) {
      throw new ConfigurationException(e.getMessage(), e);
    }
  }

  /** Its variables in the order of the file. */
  Map<String, FileVariable> variables() {
    return variables;
  }

  /** What it says about a variable; empty if nothing. */
  Optional<FileVariable> variable(String name) {
    return Optional.ofNullable(variables.get(name));
  }

  /**
   * The file with the value of {@code variable}, which is added if it is not there; nothing else
   * changes.
   *
   * @throws IllegalArgumentException if XML cannot hold the value
   */
  ConfigurationFile with(FileVariable variable) {
    XmlElement element = elements.get(variable.name());
    return new ConfigurationFile(
        path,
        element != null
            ? text.withAttribute(element, "value", variable.text())
            : text.withLastChild(root, FileVariable.ELEMENT, attributes(variable)));
  }

  /** The file without a variable that it has. */
  ConfigurationFile without(String name) {
    return new ConfigurationFile(path, text.without(elements.get(name)));
  }

  /**
   * Puts this in the place of the file on the disk.
   *
   * @throws IOException if it could not be written: then the old file stands
   */
  void write() throws IOException {
    WholeFile.replace(path, text.bytes());
  }

  private static Map<String, String> attributes(FileVariable variable) {
    Map<String, String> attributes = new LinkedHashMap<>();
    attributes.put("name", variable.name());
    attributes.put("type", variable.type().xmlName());
    attributes.put("value", variable.text());
    variable.unit().ifPresent(unit -> attributes.put("unit", unit));
    return attributes;
  }
}
