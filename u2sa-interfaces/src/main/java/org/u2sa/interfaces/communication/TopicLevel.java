package org.u2sa.interfaces.communication;

/**
 * Any name as one level of a topic, or as part of a client ID: characters that mean something there
 * are written as '%' and four upper-case hexadecimal digits. MQTT claims '/', '+', '#' and control
 * characters; NATS, whose MQTT port is one of the brokers, claims space, '.', '*' and '&gt;' for
 * its subjects.
 */
final class TopicLevel {
  private static final String BEFORE_FORMAT_3 = "/+#%";
  private static final String SINCE_FORMAT_3 = BEFORE_FORMAT_3 + " .*>";
  private static final int HEX_DIGITS = 4;
  private static final int HEX = 16;

  private TopicLevel() {}

  /** A name as it is written: one spelling for each. */
  static String of(String name) {
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
   * The name that was written by {@link #of}, or before format 3, as recordings have it.
   *
   * @throws IllegalArgumentException if no name is written so: it is empty, four hexadecimal digits
   *     do not follow a '%', or they stand for a character that needs none
   */
  static String name(String level) {
    if (level.isEmpty()) {
      throw new IllegalArgumentException("expected the source's name behind '='");
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
