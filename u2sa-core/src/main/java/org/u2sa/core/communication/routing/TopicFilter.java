package org.u2sa.core.communication.routing;

/** Syntax of topic filters (MQTT 3.1.1, section 4.7). */
public final class TopicFilter {
  private TopicFilter() {}

  /**
   * Whether a text is a valid filter. Moquette would also reject it, but log a line each time, so
   * that a client could flood the log.
   */
  public static boolean isValid(String text) {
    if (text.isEmpty() || text.indexOf('\0') >= 0) {
      return false;
    }
    for (int i = 0; i < text.length(); i++) {
      char letter = text.charAt(i);
      boolean isLast = i == text.length() - 1;
      boolean isAlone =
          (i == 0 || text.charAt(i - 1) == '/') && (isLast || text.charAt(i + 1) == '/');
      if (letter == '#' && !(isAlone && isLast) || letter == '+' && !isAlone) {
        return false;
      }
    }
    return true;
  }
}
