package org.u2sa.interfaces;

import java.util.regex.Pattern;

/**
 * Sanitises foreign text for one line of a log or terminal, so that it can neither start a new line
 * nor control the terminal: line breaks, control characters (including ESC, except tab) and
 * bidirectional marks become spaces.
 */
public final class OneLine {
  private static final Pattern CONTROLS =
      Pattern.compile(
          "[\\p{Cntrl}\\u0080-\\u009f\\u200e\\u200f\\u2028-\\u202e\\u2066-\\u2069&&[^\t]]+");

  private OneLine() {}

  /** Returns the sanitised text. */
  public static String of(String text) {
    return CONTROLS.matcher(text).replaceAll(" ");
  }
}
