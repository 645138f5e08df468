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
 * An element of an XML file that knows where it stands, so that whoever refuses it can say where.
 * Names keep their case; text and child elements do not mix. Immutable.
 *
 * @param origin the file that it was read from, as the user named it
 * @param name the name of the tag
 * @param line the line on which the tag begins, from 1
 * @param span where it stands in the file's text
 * @param attributes all attributes in the order of the file
 * @param children all child elements in the order of the file
 * @param text the text between the tags without the spaces around it; empty if there are child
 *     elements
 */
public record XmlElement(
    String origin,
    String name,
    int line,
    Span span,
    Map<String, String> attributes,
    List<XmlElement> children,
    String text) {
  /** Keeps copies that nobody can change. */
  public XmlElement {
    attributes =
        attributes.isEmpty()
            ? Collections.emptyMap() // most have none, and a file may have a million elements
            : Collections.unmodifiableMap(new LinkedHashMap<>(attributes));
    children =
        children.isEmpty()
            ? Collections.emptyList()
            : Collections.unmodifiableList(new ArrayList<>(children));
  }

  /**
   * An attribute that must be there.
   *
   * @throws BadInputException if it is not
   */
  public String attribute(String attributeName) {
    return optionalAttribute(attributeName)
        .orElseThrow(() -> error("attribute \"" + attributeName + "\" is missing"));
  }

  /** An attribute that may be there. */
  public Optional<String> optionalAttribute(String attributeName) {
    return Optional.ofNullable(attributes.get(attributeName));
  }

  /** The child elements of that name in the order of the file. */
  public List<XmlElement> children(String childName) {
    return children.stream()
        .filter(child -> child.name.equals(childName))
        .collect(Collectors.toList());
  }

  /**
   * The child element of that name, of which there may be one.
   *
   * @throws BadInputException if there are more
   */
  public Optional<XmlElement> child(String childName) {
    List<XmlElement> found = children(childName);
    if (found.size() > 1) {
      throw found
          .get(1)
          .error(
              String.format(
                  "stands twice in <%s>; it stands in line %s already", name, found.get(0).line));
    }
    return found.stream().findFirst();
  }

  /** The exception to throw for this element: {@code <origin>, line N, <element>: what}. */
  public BadInputException error(String what) {
    return new BadInputException(origin + ", line " + line + ", <" + name + ">: " + what);
  }

  /** {@link #error(String)} with what was caught. */
  public BadInputException error(String what, Throwable cause) {
    return new BadInputException(origin + ", line " + line + ", <" + name + ">: " + what, cause);
  }

  /**
   * Refuses attributes of other names than these.
   *
   * @throws BadInputException naming the first such attribute and the known ones
   */
  public void refuseUnknownAttributes(String... known) {
    for (String attribute : attributes.keySet()) {
      if (!Arrays.asList(known).contains(attribute)) {
        throw error(
            "unknown attribute \"" + attribute + "\"; " + expected("attribute", known, attribute));
      }
    }
  }

  /**
   * Refuses child elements of other names than these.
   *
   * @throws BadInputException at the first such child, naming the known ones
   */
  public void refuseUnknownChildren(String... known) {
    for (XmlElement child : children) {
      if (!Arrays.asList(known).contains(child.name)) {
        throw child.error(
            "unknown element in <" + name + ">; " + expected("element", known, child.name));
      }
    }
  }

  /**
   * Refuses text between the tags.
   *
   * @throws BadInputException showing the beginning of the text
   */
  public void refuseText() {
    if (!text.isEmpty()) {
      throw error("unexpected text \"" + XmlText.shortened(text) + "\"");
    }
  }

  private static String expected(String kind, String[] known, String given) {
    if (known.length == 0) {
      return "no " + kind + " is expected here";
    }
    return "expected "
        + String.join(", ", known)
        + NearestNames.didYouMean(given, Arrays.asList(known));
  }

  @Override
  public String toString() {
    return origin + ", line " + line + ", <" + name + ">";
  }

  /**
   * Where an element stands in the text of its file, in characters from its beginning.
   *
   * @param start index of the start tag's {@code <}
   * @param endTag index of the end tag's {@code <}; of no meaning for an empty-element tag, which
   *     has none
   */
  public record Span(int start, int endTag) {}
}
