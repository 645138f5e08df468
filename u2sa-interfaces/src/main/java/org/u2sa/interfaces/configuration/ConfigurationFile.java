package org.u2sa.interfaces.configuration;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlText;

/** Content of a service's configuration file, current or planned. Immutable. */
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
        throw variable.error("appears twice; first in line " + first.line());
      }
      variables.put(variable.name(), variable);
    }
  }

  /**
   * @throws ConfigurationException if the file is invalid; names file, line and expectation
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

  Map<String, FileVariable> variables() {
    return variables;
  }

  Optional<FileVariable> variable(String name) {
    return Optional.ofNullable(variables.get(name));
  }

  /**
   * Copy with the value of a variable set or added.
   *
   * @throws IllegalArgumentException if the value is not representable in XML
   */
  ConfigurationFile with(FileVariable variable) {
    XmlElement element = elements.get(variable.name());
    return new ConfigurationFile(
        path,
        element != null
            ? text.withAttribute(element, "value", variable.text())
            : text.withLastChild(root, FileVariable.ELEMENT, attributes(variable)));
  }

  ConfigurationFile without(String name) {
    return new ConfigurationFile(path, text.without(elements.get(name)));
  }

  /**
   * @throws IOException if writing fails; the old file is kept
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
