package org.u2sa.interfaces.xml;

import com.ctc.wstx.api.WstxInputProperties;
import com.ctc.wstx.stax.WstxInputFactory;
import java.io.StringReader;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.xml.stream.Location;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLResolver;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.u2sa.interfaces.BadInputException;

/**
 * Parses text into elements. Names the factory explicitly, because Android has no look-up for it.
 * External references are never followed: a DOCTYPE is rejected, and any other external access
 * fails.
 */
final class XmlParser {
  private static final int MAX_DEPTH = 100;
  private static final int MAX_ELEMENTS = 1_000_000;
  private static final int MAX_ATTRIBUTES = 100; // per element
  private static final int MAX_ATTRIBUTE_LENGTH = 1_000_000;
  private static final int MAX_NAME_LENGTH = 200;
  private static final char BYTE_ORDER_MARK = '\uFEFF';
  // Immutable after construction.
  private static final XMLInputFactory FACTORY = factory();

  private final String origin;
  private final XMLStreamReader reader;
  private final int offset; // offset of the reader's first character in the file's text
  private final Deque<Open> open = new ArrayDeque<>();
  private int elements;

  private XmlParser(String origin, XMLStreamReader reader, int offset) {
    this.origin = origin;
    this.reader = reader;
    this.offset = offset;
  }

  private static XMLInputFactory factory() {
    WstxInputFactory woodstox = new WstxInputFactory();
    woodstox.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    woodstox.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    XMLResolver nothing =
        (publicId, systemId, baseUri, namespace) -> {
          throw new XMLStreamException("external entities are not read: " + systemId);
        };
    woodstox.setXMLResolver(nothing);
    woodstox.setProperty(WstxInputProperties.P_DTD_RESOLVER, nothing);
    woodstox.setProperty(WstxInputProperties.P_ENTITY_RESOLVER, nothing);
    woodstox.setProperty(WstxInputProperties.P_MAX_ATTRIBUTES_PER_ELEMENT, MAX_ATTRIBUTES);
    woodstox.setProperty(WstxInputProperties.P_MAX_ATTRIBUTE_SIZE, MAX_ATTRIBUTE_LENGTH);
    woodstox
        .getConfig()
        .doParseLazily(false); // report errors as XMLStreamException at their position
    return woodstox;
  }

  private static final class Open {
    private final String name;
    private final int line;
    private final int start;
    private final Map<String, String> attributes = new LinkedHashMap<>();
    private final List<XmlElement> children = new ArrayList<>();
    private final StringBuilder text = new StringBuilder();

    Open(String name, int line, int start) {
      this.name = name;
      this.line = line;
      this.start = start;
    }
  }

  static XmlElement parse(String origin, String text) {
    int offset = !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK ? 1 : 0;
    refuseOther(origin, text.substring(offset));
    try {
      XMLStreamReader reader =
          FACTORY.createXMLStreamReader(new StringReader(text.substring(offset)));
      try {
        return new XmlParser(origin, reader, offset).root();
      } catch (XMLStreamException e) {
        throw notWellFormed(origin, e, reader.getLocation());
      } finally {
        reader.close();
      }
    } catch (XMLStreamException e) {
      throw notWellFormed(origin, e, e.getLocation()); // at the start of the file
    }
  }

  /** Refuses a file of another kind without quoting it: who named it may not be its reader. */
  private static void refuseOther(String origin, String text) {
    int at = 0;
    while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
      at++;
    }
    if (at < text.length() && text.charAt(at) != '<') {
      long line = 1 + text.substring(0, at).chars().filter(c -> c == '\n').count();
      throw new BadInputException(
          origin + ", line " + line + ": not well-formed XML: expected < at its beginning");
    }
  }

  private XmlElement root() throws XMLStreamException {
    XmlElement last = null;
    while (reader.hasNext()) {
      switch (reader.next()) {
        case XMLStreamConstants.START_ELEMENT -> start();
        case XMLStreamConstants.END_ELEMENT -> last = end();
        case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA -> text();
        case XMLStreamConstants.DTD ->
            throw new BadInputException(
                origin + ", line " + line() + ": a DOCTYPE is not allowed here");
        default -> {
          // ignore comments, processing instructions and white space around the root
        }
      }
    }
    return last;
  }

  private void start() {
    if (open.size() == MAX_DEPTH) {
      throw new BadInputException(
          origin + ", line " + line() + ": more than " + MAX_DEPTH + " nested elements");
    }
    if (++elements > MAX_ELEMENTS) {
      throw new BadInputException(
          origin + ", line " + line() + ": more than " + MAX_ELEMENTS + " elements");
    }
    Open element = new Open(name(), line(), position());
    for (int i = 0; i < reader.getAttributeCount(); i++) {
      String prefix = reader.getAttributePrefix(i);
      String local = reader.getAttributeLocalName(i);
      element.attributes.put(qualified(prefix, local), reader.getAttributeValue(i));
    }
    open.push(element);
  }

  private XmlElement end() {
    Open closed = open.pop();
    String text = closed.text.toString().trim();
    XmlElement element =
        new XmlElement(
            origin,
            closed.name,
            closed.line,
            new XmlElement.Span(closed.start, position()),
            closed.attributes,
            closed.children,
            text);
    if (!closed.children.isEmpty() && !text.isEmpty()) {
      throw element.error("text \"" + XmlElement.shortened(text) + "\" is between its elements");
    }
    if (!open.isEmpty()) {
      open.peek().children.add(element);
    }
    return element;
  }

  private void text() {
    if (!open.isEmpty()) {
      open.peek().text.append(reader.getText());
    }
  }

  private String name() {
    return qualified(reader.getPrefix(), reader.getLocalName());
  }

  private String qualified(String prefix, String local) {
    if (local.length() > MAX_NAME_LENGTH) {
      throw new BadInputException(
          String.format(
              "%s, line %s: the name \"%s\" is longer than %s characters",
              origin, line(), XmlElement.shortened(local), MAX_NAME_LENGTH));
    }
    return prefix == null || prefix.isEmpty() ? local : prefix + ":" + local;
  }

  private int line() {
    return reader.getLocation().getLineNumber();
  }

  private int position() {
    return reader.getLocation().getCharacterOffset() + offset;
  }

  private static BadInputException notWellFormed(
      String origin, XMLStreamException e, Location reached) {
    // Drops the position Woodstox appends on a second line, because it is already given in front.
    String what = e.getMessage().split("\\n\\s*at \\[row", 2)[0].trim();
    Location at = e.getLocation() == null ? reached : e.getLocation(); // null for exceeded limits
    String where = at == null ? "" : ", line " + Math.max(1, at.getLineNumber());
    return new BadInputException(
        origin + where + ": not well-formed XML: " + XmlElement.oneLine(what), e);
  }
}
