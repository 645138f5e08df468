package org.u2sa.report;

/** Escapes text for XML and HTML files assembled as strings. */
public final class EscapedXml {

  private EscapedXml() {}

  /**
   * Returns {@code text} as character data or attribute value: markup is escaped, and characters
   * forbidden in XML 1.0 are replaced by U+FFFD.
   */
  public static String of(String text) {
    StringBuilder xml = new StringBuilder(text.length() + 16);
    text.codePoints().forEach(c -> append(xml, c));
    return xml.toString();
  }

  private static void append(StringBuilder xml, int c) {
    switch (c) {
      case '&' -> xml.append("&amp;");
      case '<' -> xml.append("&lt;");
      case '>' -> xml.append("&gt;");
      case '"' -> xml.append("&quot;");
      default -> xml.appendCodePoint(isAllowed(c) ? c : 0xFFFD);
    }
  }

  private static boolean isAllowed(int c) { // XML 1.0, production 2
    return c == 0x9
        || c == 0xA
        || c == 0xD
        || c >= 0x20 && c <= 0xD7FF
        || c >= 0xE000 && c <= 0xFFFD
        || c >= 0x10000;
  }
}
