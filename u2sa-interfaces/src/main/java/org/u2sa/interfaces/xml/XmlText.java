package org.u2sa.interfaces.xml;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.UnsupportedCharsetException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;

/** An XML file as text. {@link #root} parses it; edits preserve all other characters. Immutable. */
public final class XmlText {
  /** Maximum file size; a world of a hundred thousand points takes a third of it. */
  private static final int MAX_BYTES = 16 * 1024 * 1024;

  private static final int CHUNK = 8192;
  private static final int DECLARATION_LENGTH = 200;
  private static final Pattern ENCODING =
      Pattern.compile("^<\\?xml[^>]*\\sencoding\\s*=\\s*[\"']([^\"']+)[\"']");

  private final String origin;
  private final String text;
  private final Charset charset;

  private XmlText(String origin, String text, Charset charset) {
    this.origin = origin;
    this.text = text;
    this.charset = charset;
  }

  /**
   * Reads a file, decoded by its byte order mark or XML declaration, otherwise as UTF-8. Only
   * regular files, because reading a device or pipe may block or never end.
   *
   * @throws BadInputException if it is missing, unreadable, too large or incorrectly encoded
   */
  public static XmlText read(Path file) {
    try {
      BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
      if (!attributes.isRegularFile()) {
        throw new BadInputException(
            file
                + (attributes.isDirectory()
                    ? ": is a directory, expected an XML file"
                    : ": is a device or similar, expected a regular file"));
      }
      if (attributes.size() == 0) {
        throw new BadInputException(file + ": is empty, expected an XML file");
      }
      if (attributes.size() > MAX_BYTES) {
        throw tooLarge(file.toString());
      }
      try (InputStream in = Files.newInputStream(file)) {
        return of(in, file.toString());
      }
    } catch (NoSuchFileException e) {
      throw new BadInputException(file + ": there is no such file", e);
    } catch (AccessDeniedException e) {
      throw new BadInputException(file + ": may not be read by this user", e);
    } catch (IOException e) {
      throw new BadInputException(file + ": cannot be read: " + e, e);
    }
  }

  static XmlText of(InputStream in, String origin) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    byte[] chunk = new byte[CHUNK];
    for (int n = in.read(chunk); n >= 0 && bytes.size() <= MAX_BYTES; n = in.read(chunk)) {
      bytes.write(chunk, 0, n);
    }
    return of(bytes.toByteArray(), origin);
  }

  static XmlText of(byte[] bytes, String origin) {
    if (bytes.length > MAX_BYTES) {
      throw tooLarge(origin);
    }
    Charset charset = charset(bytes, origin);
    CharsetDecoder decoder =
        charset
            .newDecoder()
            .onMalformedInput(CodingErrorAction.REPORT)
            .onUnmappableCharacter(CodingErrorAction.REPORT);
    ByteBuffer in = ByteBuffer.wrap(bytes);
    try {
      return new XmlText(origin, decoder.decode(in).toString(), charset);
    } catch (CharacterCodingException e) {
      long line = 1;
      for (int i = 0; i < in.position(); i++) {
        line += bytes[i] == '\n' ? 1 : 0;
      }
      throw new BadInputException(
          origin + ", line " + line + ": these bytes are not " + charset.name() + " text", e);
    }
  }

  /**
   * @throws BadInputException if the text is not well-formed or has another root
   */
  public XmlElement root(String expectedRoot) {
    XmlElement root = XmlParser.parse(origin, text);
    if (!root.name().equals(expectedRoot)) {
      throw root.error("expected the root element <" + expectedRoot + ">");
    }
    return root;
  }

  /**
   * Copy with another value of an existing attribute of an element of this text.
   *
   * @throws IllegalArgumentException if a character is not representable in XML
   */
  public XmlText withAttribute(XmlElement element, String attribute, String value) {
    XmlAttributes.Value place = XmlAttributes.find(text, element.span().start(), attribute);
    return with(place.start(), place.end(), XmlAttributes.escaped(value, place.quote(), charset));
  }

  /**
   * Copy with another empty element as the last child, on its own line and indented like the
   * previous one.
   *
   * @throws IllegalArgumentException if a character is not representable in XML
   */
  public XmlText withLastChild(XmlElement parent, String name, Map<String, String> attributes) {
    StringBuilder child = new StringBuilder("<").append(name);
    attributes.forEach(
        (key, value) ->
            child
                .append(' ')
                .append(key)
                .append("=\"")
                .append(XmlAttributes.escaped(value, '"', charset))
                .append('"'));
    child.append("/>");
    String newline = text.contains("\r\n") ? "\r\n" : "\n";
    int end = parent.span().endTag();
    String parentIndent = indent(parent.span().start());
    String childIndent =
        parent.children().isEmpty()
            ? parentIndent + "  "
            : indent(parent.children().get(parent.children().size() - 1).span().start());
    int close = XmlAttributes.tagEnd(text, parent.span().start());
    if (text.charAt(close - 1) == '/') { // <parent/>: expand to hold the child
      String endTag = "</" + parent.name() + ">";
      return with(
          close - 1,
          close + 1,
          ">" + newline + childIndent + child + newline + parentIndent + endTag);
    }
    int lineStart = text.lastIndexOf('\n', end - 1) + 1;
    boolean ownLine = text.substring(lineStart, end).trim().isEmpty();
    return ownLine
        ? with(lineStart, lineStart, childIndent + child + newline)
        : with(end, end, newline + childIndent + child + newline + parentIndent);
  }

  /** Copy without an element of this text, and without its line if otherwise empty. */
  public XmlText without(XmlElement element) {
    int from = element.span().start();
    int close = XmlAttributes.tagEnd(text, from);
    boolean empty = text.charAt(close - 1) == '/';
    int to = 1 + (empty ? close : text.indexOf('>', element.span().endTag()));
    int lineStart = text.lastIndexOf('\n', from - 1) + 1;
    int lineEnd = text.indexOf('\n', to) + 1;
    boolean ownLine =
        lineEnd > 0
            && text.substring(lineStart, from).trim().isEmpty()
            && text.substring(to, lineEnd).trim().isEmpty();
    return ownLine ? with(lineStart, lineEnd, "") : with(from, to, "");
  }

  public String text() {
    return text;
  }

  public byte[] bytes() {
    return text.getBytes(charset);
  }

  private XmlText with(int from, int to, String replacement) {
    return new XmlText(origin, text.substring(0, from) + replacement + text.substring(to), charset);
  }

  private String indent(int offset) {
    int lineStart = text.lastIndexOf('\n', offset - 1) + 1;
    String before = text.substring(lineStart, offset);
    return before.trim().isEmpty() ? before : "";
  }

  private static Charset charset(byte[] bytes, String origin) {
    if (bytes.length >= 2 && (bytes[0] & 0xFF) == 0xFE && (bytes[1] & 0xFF) == 0xFF) {
      return StandardCharsets.UTF_16BE;
    }
    if (bytes.length >= 2 && (bytes[0] & 0xFF) == 0xFF && (bytes[1] & 0xFF) == 0xFE) {
      return StandardCharsets.UTF_16LE;
    }
    String head =
        new String(
            bytes, 0, Math.min(bytes.length, DECLARATION_LENGTH), StandardCharsets.ISO_8859_1);
    Matcher matcher = ENCODING.matcher(head);
    if (!matcher.find()) {
      return StandardCharsets.UTF_8;
    }
    try {
      return Charset.forName(matcher.group(1));
    } catch (IllegalCharsetNameException | UnsupportedCharsetException e) {
      throw new BadInputException(
          origin + ", line 1: unknown encoding \"" + matcher.group(1) + "\"; expected UTF-8", e);
    }
  }

  private static BadInputException tooLarge(String origin) {
    return new BadInputException(
        origin + ": is larger than " + MAX_BYTES / (1024 * 1024) + " MB, the maximum");
  }
}
