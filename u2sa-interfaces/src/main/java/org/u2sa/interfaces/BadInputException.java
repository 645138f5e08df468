package org.u2sa.interfaces;

/**
 * Input of a user that cannot be used: a file, an argument, a value. The message alone must do: it
 * names the place, the value and what was expected, and the command line prints nothing else. It is
 * one line, whatever the input holds: line ends and other control characters become spaces.
 */
public class BadInputException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /**
   * @param message place, value and what was expected, in one sentence
   */
  public BadInputException(String message) {
    super(OneLine.of(message));
  }

  /**
   * @param message place, value and what was expected, in one sentence
   * @param cause what was caught
   */
  public BadInputException(String message, Throwable cause) {
    super(OneLine.of(message), cause);
  }
}
