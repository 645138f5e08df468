package org.u2sa.interfaces.xml;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;

/**
 * An XML element with its position, for error messages. Mixed content is not supported.
 *
 * @param origin source file, as named by the user
 * @param line line of the start tag, from 1
 * @param span position in the file's text
 * @param text trimmed text content; empty if there are child elements
 */
public record XmlElement(
    String origin,
    String name,
    int line,
    Span span,
    Map<String, String> attributes,
    List<XmlElement> children,
    String text) {
  private static final int SHORT = 40;

  public XmlElement {
    attributes =
        attributes.isEmpty()
            ? Collections
                .emptyMap() // saves memory: most elements have none, and a file may have a million
            : Collections.unmodifiableMap(new LinkedHashMap<>(attributes));
    children =
        children.isEmpty()
            ? Collections.emptyList()
            : Collections.unmodifiableList(new ArrayList<>(children));
  }

  /** Copy with other content at the same place in the file. */
  public XmlElement with(
      Map<String, String> newAttributes, List<XmlElement> newChildren, String newText) {
    return new XmlElement(origin, name, line, span, newAttributes, newChildren, newText);
  }

  /**
   * @throws BadInputException if it is missing
   */
  public String attribute(String attributeName) {
    return optionalAttribute(attributeName)
        .orElseThrow(() -> error("attribute \"" + attributeName + "\" is missing"));
  }

  public Optional<String> optionalAttribute(String attributeName) {
    return Optional.ofNullable(attributes.get(attributeName));
  }

  public List<XmlElement> children(String childName) {
    return children.stream()
        .filter(child -> child.name.equals(childName))
        .collect(Collectors.toList());
  }

  /**
   * @throws BadInputException if there are several
   */
  public Optional<XmlElement> child(String childName) {
    List<XmlElement> found = children(childName);
    if (found.size() > 1) {
      throw found
          .get(1)
          .error(String.format("appears twice in <%s>; first in line %s", name, found.get(0).line));
    }
    return found.stream().findFirst();
  }

  /**
   * The only child with this name.
   *
   * @throws BadInputException if it is missing, or given more than once
   */
  public XmlElement requiredChild(String childName) {
    return child(childName).orElseThrow(() -> error("lacks <" + childName + ">"));
  }

  /** Creates an exception for this element: {@code <origin>, line N, <element>: what}. */
  public BadInputException error(String what) {
    return new BadInputException(origin + ", line " + line + ", <" + name + ">: " + what);
  }

  public BadInputException error(String what, Throwable cause) {
    return new BadInputException(origin + ", line " + line + ", <" + name + ">: " + what, cause);
  }

  /**
   * @throws BadInputException naming the first unknown attribute and the known ones
   */
  public void refuseUnknownAttributes(String... known) {
    for (String attribute : attributes.keySet()) {
      if (!Arrays.asList(known).contains(attribute)) {
        throw error(
            "unknown attribute \""
                + attribute
                + "\"; "
                + expected("attribute", Arrays.asList(known), attribute));
      }
    }
  }

  /**
   * @throws BadInputException at the first unknown child, naming the known ones
   */
  public void refuseUnknownChildren(String... known) {
    for (XmlElement child : children) {
      if (!Arrays.asList(known).contains(child.name)) {
        throw unknown(child, Arrays.asList(known));
      }
    }
  }

  /** Error for an unknown child; quotes it and the known ones. */
  public BadInputException unknown(XmlElement child, List<String> known) {
    return child.error(
        "unknown element in <" + name + ">; " + expected("element", known, child.name));
  }

  /**
   * @throws BadInputException quoting the start of the text, if present
   */
  public void refuseText() {
    if (!text.isEmpty()) {
      throw error("unexpected text \"" + shortened(text) + "\"");
    }
  }

  static String shortened(String text) {
    String line = oneLine(text);
    return line.length() <= SHORT ? line : line.substring(0, SHORT) + "…";
  }

  /** Replaces line breaks and control characters, for a message. */
  static String oneLine(String text) {
    return text.replaceAll("[\\p{Cntrl}\\s]+", " ");
  }

  private static String expected(String kind, List<String> known, String given) {
    if (known.isEmpty()) {
      return "no " + kind + " is expected here";
    }
    return "expected " + String.join(", ", known) + NearestNames.didYouMean(given, known);
  }

  @Override
  public String toString() {
    return origin + ", line " + line + ", <" + name + ">";
  }

  /**
   * Character offsets of an element in its file.
   *
   * @param start of the start tag's {@code <}
   * @param endTag of the end tag's {@code <}; undefined for an empty-element tag
   */
  public record Span(int start, int endTag) {}
}
