package org.u2sa.interfaces;

/**
 * Invalid user input: a file, an argument or a value. The message must suffice on its own, because
 * the command line prints nothing else: it names the place, the value and the expectation. It is
 * always one line; line breaks and other control characters become spaces.
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
   * @param cause the cause
   */
  public BadInputException(String message, Throwable cause) {
    super(OneLine.of(message), cause);
  }
}
