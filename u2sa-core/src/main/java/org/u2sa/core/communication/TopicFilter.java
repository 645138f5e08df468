package org.u2sa.core.communication;

/** The syntax of topic filters (MQTT 3.1.1, section 4.7). */
final class TopicFilter {
  private TopicFilter() {}

  /**
   * Whether a text is a filter. Moquette would refuse it too, but print a line for each, which a
   * client could fill the log with.
   */
  static boolean isValid(String text) {
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
