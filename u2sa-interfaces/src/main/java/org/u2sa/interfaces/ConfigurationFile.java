package org.u2sa.interfaces;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlText;

/** The configuration file of one service as it stands on the disk at one moment. Immutable. */
final class ConfigurationFile {
  private static final String ROOT = "configuration";

  private final Path path;
  private final XmlText text;
  private final XmlElement root;
  private final Map<String, XmlElement> elements = new LinkedHashMap<>();
  private final Map<String, FileVariable> variables = new LinkedHashMap<>();

  private ConfigurationFile(Path path) {
    this.path = path;
    text = XmlText.read(path);
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
      return new ConfigurationFile(path);
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
   * Writes the file with another value of a variable, or with the variable added; nothing else
   * changes.
   *
   * @throws IOException if it could not be written: then the old file stands
   * @throws IllegalArgumentException if XML cannot hold the value
   */
  void write(BoundVariable variable, String name, Object value) throws IOException {
    String valueText = variable.fileText(value);
    XmlElement element = elements.get(name);
    XmlText changed =
        element != null
            ? text.withAttribute(element, "value", valueText)
            : text.withLastChild(root, FileVariable.ELEMENT, attributes(variable, name, valueText));
    WholeFile.replace(path, changed.bytes());
  }

  private static Map<String, String> attributes(
      BoundVariable variable, String name, String valueText) {
    Map<String, String> attributes = new LinkedHashMap<>();
    attributes.put("name", name);
    attributes.put("type", variable.type().xmlName());
    attributes.put("value", valueText);
    if (!variable.unit().isEmpty()) {
      attributes.put("unit", variable.unit());
    }
    return attributes;
  }
}
