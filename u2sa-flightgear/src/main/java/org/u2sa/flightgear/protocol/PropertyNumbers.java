package org.u2sa.flightgear.protocol;

import java.util.List;

/**
 * Parses the numbers of a line; stricter than {@link Double#parseDouble}, which also accepts "1d",
 * " 1 ", "NaN" and "0x1p3".
 */
final class PropertyNumbers {
  private static final int SHOWN = 24;

  private PropertyNumbers() {}

  static List<String> split(String line) {
    return List.of(line.split(",", -1));
  }

  static boolean isNumber(String text) {
    try {
      return text.chars().allMatch(each -> "0123456789+-.eE".indexOf(each) >= 0)
          && Double.isFinite(Double.parseDouble(text));
    } catch (NumberFormatException notOne) {
      return false;
    }
  }

  static double parse(String node, String text) throws MalformedLineException {
    if (!isNumber(text)) {
      throw new MalformedLineException(node + ": \"" + shown(text) + "\" is not a number");
    }
    return Double.parseDouble(text);
  }

  /** The beginning of a text, without characters that would garble a log. */
  static String shown(String text) {
    boolean isLong = text.length() > SHOWN;
    String begin = isLong ? text.substring(0, SHOWN) : text;
    return begin.replaceAll("[^ -~]", "?") + (isLong ? "…" : "");
  }
}
