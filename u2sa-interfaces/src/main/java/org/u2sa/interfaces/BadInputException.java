package org.u2sa.interfaces;

import java.util.regex.Pattern;

/**
 * Input of a user that cannot be used: a file, an argument, a value. The message alone must do: it
 * names the place, the value and what was expected, and the command line prints nothing else. It is
 * one line, whatever the input holds: line ends and other control characters become spaces.
 */
public class BadInputException extends RuntimeException {
  private static final long serialVersionUID = 1L;
  private static final Pattern CONTROLS =
      Pattern.compile("[\\p{Cntrl}\\u0080-\\u009f\\u2028\\u2029]+");

  /**
   * @param message place, value and what was expected, in one sentence
   */
  public BadInputException(String message) {
    super(oneLine(message));
  }

  /**
   * @param message place, value and what was expected, in one sentence
   * @param cause what was caught
   */
  public BadInputException(String message, Throwable cause) {
    super(oneLine(message), cause);
  }

  private static String oneLine(String message) {
    return CONTROLS.matcher(message).replaceAll(" ");
  }
}
