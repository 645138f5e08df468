package org.u2sa.interfaces.communication;

/**
 * Encodes a name as a topic level or part of a client ID: reserved characters become '%' and four
 * upper-case hexadecimal digits. Reserved are '/', '+', '#' and control characters in MQTT, and
 * space, '.', '*' and '&gt;' in NATS subjects.
 */
public final class TopicLevel {
  private static final String BEFORE_FORMAT_3 = "/+#%";
  private static final String SINCE_FORMAT_3 = BEFORE_FORMAT_3 + " .*>";
  private static final int HEX_DIGITS = 4;
  private static final int HEX = 16;

  private TopicLevel() {}

  /** Encodes a name; the encoding is unique. */
  public static String of(String name) {
    return written(name, SINCE_FORMAT_3);
  }

  private static String written(String name, String escaped) {
    StringBuilder level = new StringBuilder();
    for (char c : name.toCharArray()) {
      if (escaped.indexOf(c) >= 0 || Character.isISOControl(c)) {
        level.append(String.format("%%%04X", (int) c));
      } else {
        level.append(c);
      }
    }
    return level.toString();
  }

  /**
   * Decodes a name encoded by {@link #of}, or by formats before 3, as found in recordings.
   *
   * @throws IllegalArgumentException if the text is not a valid encoding
   */
  static String name(String level) {
    if (level.isEmpty()) {
      throw new IllegalArgumentException("expected the source's name after '='");
    }
    StringBuilder decoded = new StringBuilder();
    for (int i = 0; i < level.length(); i++) {
      char c = level.charAt(i);
      if (c != '%') {
        decoded.append(c);
        continue;
      }
      int end = i + 1 + HEX_DIGITS;
      if (end > level.length() || !level.substring(i + 1, end).matches("[0-9A-Fa-f]{4}")) {
        throw new IllegalArgumentException(
            "source \"" + level + "\": expected four hexadecimal digits after '%'");
      }
      decoded.append((char) Integer.parseInt(level.substring(i + 1, end), HEX));
      i = end - 1;
    }
    String name = decoded.toString();
    if (!of(name).equals(level) && !written(name, BEFORE_FORMAT_3).equals(level)) {
      throw new IllegalArgumentException("source \"" + level + "\": expected \"" + of(name) + "\"");
    }
    return name;
  }
}
