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
 * An XML element with its position, for error messages. Names are case-sensitive; mixed content is
 * not supported. Immutable.
 *
 * @param origin source file, as named by the user
 * @param name tag name
 * @param line line of the start tag, from 1
 * @param span position in the file's text
 * @param attributes all attributes in file order
 * @param children all child elements in file order
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

  /** Makes unmodifiable copies. */
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

  /**
   * A required attribute.
   *
   * @throws BadInputException if it is missing
   */
  public String attribute(String attributeName) {
    return optionalAttribute(attributeName)
        .orElseThrow(() -> error("attribute \"" + attributeName + "\" is missing"));
  }

  /** An optional attribute. */
  public Optional<String> optionalAttribute(String attributeName) {
    return Optional.ofNullable(attributes.get(attributeName));
  }

  /** Child elements by name, in file order. */
  public List<XmlElement> children(String childName) {
    return children.stream()
        .filter(child -> child.name.equals(childName))
        .collect(Collectors.toList());
  }

  /**
   * The only child element with this name, if present.
   *
   * @throws BadInputException if there are several
   */
  public Optional<XmlElement> child(String childName) {
    List<XmlElement> found = children(childName);
    if (found.size() > 1) {
      throw found
          .get(1)
          .error(
              String.format(
                  "appears twice in <%s>; it is in line %s already", name, found.get(0).line));
    }
    return found.stream().findFirst();
  }

  /** Creates an exception for this element: {@code <origin>, line N, <element>: what}. */
  public BadInputException error(String what) {
    return new BadInputException(origin + ", line " + line + ", <" + name + ">: " + what);
  }

  /** {@link #error(String)} with a cause. */
  public BadInputException error(String what, Throwable cause) {
    return new BadInputException(origin + ", line " + line + ", <" + name + ">: " + what, cause);
  }

  /**
   * Rejects unknown attributes.
   *
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
   * Rejects unknown child elements.
   *
   * @throws BadInputException at the first unknown child, naming the known ones
   */
  public void refuseUnknownChildren(String... known) {
    for (XmlElement child : children) {
      if (!Arrays.asList(known).contains(child.name)) {
        throw unknown(child, Arrays.asList(known));
      }
    }
  }

  /** Error for a child that is none of the known ones; quotes both. */
  public BadInputException unknown(XmlElement child, List<String> known) {
    return child.error(
        "unknown element in <" + name + ">; " + expected("element", known, child.name));
  }

  /**
   * Rejects text content.
   *
   * @throws BadInputException quoting the start of the text
   */
  public void refuseText() {
    if (!text.isEmpty()) {
      throw error("unexpected text \"" + shortened(text) + "\"");
    }
  }

  /** Shortens a text to one line, for a message. */
  static String shortened(String text) {
    String line = oneLine(text);
    return line.length() <= SHORT ? line : line.substring(0, SHORT) + "…";
  }

  /** Sanitises text for a message: no line breaks or control characters. */
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
   * Position of an element in its file's text, as character offsets.
   *
   * @param start index of the start tag's {@code <}
   * @param endTag index of the end tag's {@code <}; undefined for an empty-element tag
   */
  public record Span(int start, int endTag) {}
}
