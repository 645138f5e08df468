package org.u2sa.interfaces;

import java.util.regex.Pattern;

/**
 * Sanitises foreign text for one line of a log or terminal: line breaks, control characters
 * (including ESC, except tab), direction marks and zero-width characters become spaces.
 */
public final class OneLine {
  private static final Pattern CONTROLS =
      Pattern.compile(
          "[\\p{Cntrl}\\u0080-\\u009f\\u2028\\u2029"
              + "\\p{Cf}" // invisible formatting, such as U+061C, U+200B, U+FEFF
              + "\\u034f\\u115f\\u1160\\u3164\\uffa0" // letters and marks without width
              + "&&[^\t]]+");

  private OneLine() {}

  public static String of(String text) {
    return CONTROLS.matcher(text).replaceAll(" ");
  }
}
