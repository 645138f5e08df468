package org.u2sa.interfaces;

import java.util.regex.Pattern;

/**
 * A text of somebody else's on one line of a log or a terminal, where it can neither begin a line
 * of its own nor command the terminal: line ends, control characters (ESC among them, not the tab)
 * and the marks that turn the direction of writing become spaces.
 */
public final class OneLine {
  private static final Pattern CONTROLS =
      Pattern.compile(
          "[\\p{Cntrl}\\u0080-\\u009f\\u200e\\u200f\\u2028-\\u202e\\u2066-\\u2069&&[^\t]]+");

  private OneLine() {}

  /** The text without them. */
  public static String of(String text) {
    return CONTROLS.matcher(text).replaceAll(" ");
  }
}
