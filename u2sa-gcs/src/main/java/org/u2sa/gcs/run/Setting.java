package org.u2sa.gcs.run;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A variable set on the command line.
 *
 * @param service the simple name of the service's class, or CommunicationManager
 * @param variable the variable's name
 * @param value Boolean, Integer, Double or String, as it looks
 */
public record Setting(String service, String variable, Object value) {
  private static final Pattern FORM = Pattern.compile("([^:=]+):([^=]+)=(.*)", Pattern.DOTALL);

  /**
   * Reads {@code SERVICE:VARIABLE=VALUE}.
   *
   * @throws IllegalArgumentException if the text is not of that form
   */
  public static Setting parse(String text) {
    Matcher matcher = FORM.matcher(text);
    if (!matcher.matches()) {
      throw new IllegalArgumentException("\"" + text + "\": expected SERVICE:VARIABLE=VALUE");
    }
    return new Setting(matcher.group(1), matcher.group(2), value(matcher.group(3)));
  }

  private static Object value(String text) {
    if (text.equalsIgnoreCase("true") || text.equalsIgnoreCase("false")) {
      return Boolean.valueOf(text);
    }
    if (text.matches("[+-]?\\d{1,9}")) {
      return Integer.valueOf(text);
    }
    if (text.matches("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?")) {
      return Double.valueOf(text);
    }
    return text;
  }
}
