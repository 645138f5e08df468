package org.u2sa.interfaces;

/**
 * Invalid user input: a file, an argument or a value. The message must suffice on its own, because
 * the command line prints nothing else: it names the place, the value and the expectation. It is
 * always one line; line breaks and other control characters become spaces.
 */
public class BadInputException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public BadInputException(String message) {
    super(OneLine.of(message));
  }

  public BadInputException(String message, Throwable cause) {
    super(OneLine.of(message), cause);
  }
}
