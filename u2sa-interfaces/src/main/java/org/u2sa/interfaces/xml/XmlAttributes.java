package org.u2sa.interfaces.xml;

import java.nio.charset.Charset;
import java.nio.charset.CharsetEncoder;

/** Locates and edits attribute values in well-formed XML text. */
final class XmlAttributes {
  private static final int FIRST_PRINTABLE = 0x20;
  private static final int LAST_ASCII = 0x7E;
  private static final int LAST_CONTROL = 0x9F;
  private static final int LINE_SEPARATOR = 0x2028;

  private XmlAttributes() {}

  record Value(int start, int end, char quote) {}

  /** Position of an attribute's value in the start tag whose {@code <} is at {@code tag}. */
  static Value find(String text, int tag, String attribute) {
    int at = tag;
    while (!Character.isWhitespace(text.charAt(at))) {
      at++;
    }
    while (true) {
      at = skipSpace(text, at);
      int nameStart = at;
      while (text.charAt(at) != '=' && !Character.isWhitespace(text.charAt(at))) {
        at++;
      }
      String name = text.substring(nameStart, at);
      int open = skipSpace(text, skipSpace(text, at) + 1); // skip the equals sign
      char quote = text.charAt(open);
      int close = text.indexOf(quote, open + 1);
      if (name.equals(attribute)) {
        return new Value(open + 1, close, quote);
      }
      at = close + 1;
    }
  }

  /** Index of the {@code >} of the tag whose {@code <} is at {@code tag}. */
  static int tagEnd(String text, int tag) {
    int at = tag;
    while (text.charAt(at) != '>') {
      char c = text.charAt(at);
      at = c == '"' || c == '\'' ? text.indexOf(c, at + 1) + 1 : at + 1;
    }
    return at;
  }

  /**
   * Escapes a value for a file of this encoding.
   *
   * @throws IllegalArgumentException if a character is not representable in XML
   */
  static String escaped(String value, char quote, Charset charset) {
    CharsetEncoder encoder = charset.newEncoder();
    StringBuilder out = new StringBuilder(value.length());
    int length;
    for (int i = 0; i < value.length(); i += length) {
      int c = value.codePointAt(i);
      length = Character.charCount(c);
      if (!allowed(c)) {
        throw new IllegalArgumentException(
            String.format("character U+%04X at position %d is not allowed in XML", c, i + 1));
      }
      if (c == '&') {
        out.append("&amp;");
      } else if (c == '<') {
        out.append("&lt;");
      } else if (c == '>') {
        out.append("&gt;");
      } else if (c == quote) {
        out.append(quote == '"' ? "&quot;" : "&apos;");
      } else if (altered(c) || !encoder.canEncode(value.subSequence(i, i + length))) {
        out.append("&#").append(c).append(';');
      } else {
        out.appendCodePoint(c);
      }
    }
    return out.toString();
  }

  // XML 1.0, production 2 (Char).
  private static boolean allowed(int c) {
    return c == '\t'
        || c == '\n'
        || c == '\r'
        || c >= FIRST_PRINTABLE && c <= 0xD7FF
        || c >= 0xE000 && c <= 0xFFFD
        || c >= 0x10000;
  }

  // White space that would be normalised to spaces on reading (XML 1.0, 3.3.3; line ends of XML
  // 1.1, 2.11).
  private static boolean altered(int c) {
    return c < FIRST_PRINTABLE || c > LAST_ASCII && c <= LAST_CONTROL || c == LINE_SEPARATOR;
  }

  private static int skipSpace(String text, int from) {
    int at = from;
    while (Character.isWhitespace(text.charAt(at))) {
      at++;
    }
    return at;
  }
}
