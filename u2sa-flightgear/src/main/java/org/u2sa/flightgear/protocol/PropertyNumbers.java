package org.u2sa.flightgear.protocol;

import java.util.ArrayList;
import java.util.List;

/**
 * Parses the numbers of a line; stricter than {@link Double#parseDouble}, which also accepts "1d",
 * " 1 ", "NaN" and "0x1p3".
 */
final class PropertyNumbers {
  private static final int SHOWN = 24;

  private PropertyNumbers() {}

  static List<String> split(String line) {
    List<String> parts = new ArrayList<>();
    int from = 0;
    for (int comma = line.indexOf(','); comma >= 0; comma = line.indexOf(',', from)) {
      parts.add(line.substring(from, comma));
      from = comma + 1;
    }
    parts.add(line.substring(from));
    return parts;
  }

  static boolean isNumber(String text) {
    if (text.isEmpty()) {
      return false;
    }
    for (int i = 0; i < text.length(); i++) {
      if ("0123456789+-.eE".indexOf(text.charAt(i)) < 0) {
        return false;
      }
    }
    try {
      return Double.isFinite(Double.parseDouble(text));
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

  /** The beginning of a text, without what would spoil a log. */
  static String shown(String text) {
    StringBuilder shown = new StringBuilder();
    for (int i = 0; i < Math.min(SHOWN, text.length()); i++) {
      char c = text.charAt(i);
      shown.append(c >= ' ' && c < 127 ? c : '?');
    }
    return text.length() > SHOWN ? shown + "…" : shown.toString();
  }
}
