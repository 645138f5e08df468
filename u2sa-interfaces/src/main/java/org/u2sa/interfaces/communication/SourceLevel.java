package org.u2sa.interfaces.communication;

/**
 * A source's name as one level of a topic: '/', '+', '#', '%' and control characters, which topics
 * give a meaning or forbid, are written as '%' and four hexadecimal digits.
 */
final class SourceLevel {
  private static final int HEX_DIGITS = 4;
  private static final int HEX = 16;

  private SourceLevel() {}

  static String encode(String source) {
    StringBuilder level = new StringBuilder();
    for (char c : source.toCharArray()) {
      if ("/+#%".indexOf(c) >= 0 || Character.isISOControl(c)) {
        level.append(String.format("%%%04X", (int) c));
      } else {
        level.append(c);
      }
    }
    return level.toString();
  }

  /**
   * The name that was {@link #encode}d.
   *
   * @throws IllegalArgumentException if no name is written so: it is empty, four hexadecimal digits
   *     do not follow a '%', or they stand for a character that needs none; so that a source has
   *     one topic
   */
  static String decode(String level) {
    StringBuilder source = new StringBuilder();
    for (int i = 0; i < level.length(); i++) {
      char c = level.charAt(i);
      if (c != '%') {
        source.append(c);
        continue;
      }
      int end = i + 1 + HEX_DIGITS;
      if (end > level.length() || !level.substring(i + 1, end).matches("[0-9A-Fa-f]{4}")) {
        throw new IllegalArgumentException(
            "source \"" + level + "\": expected four hexadecimal digits after '%'");
      }
      source.append((char) Integer.parseInt(level.substring(i + 1, end), HEX));
      i = end - 1;
    }
    if (level.isEmpty()) {
      throw new IllegalArgumentException("expected the source's name behind '='");
    }
    String written = encode(source.toString());
    if (!written.equals(level)) {
      throw new IllegalArgumentException("source \"" + level + "\": expected \"" + written + "\"");
    }
    return source.toString();
  }
}
