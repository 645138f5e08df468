package org.u2sa.interfaces;

/**
 * Thrown when a run fails for a reason fully explained by the message: the command line prints it
 * without a stack trace and exits with 1.
 */
public class RunFailedException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  public RunFailedException(String message) {
    super(message);
  }

  /** Adds a cause, shown with {@code --debug}. */
  public RunFailedException(String message, Throwable cause) {
    super(message, cause);
  }
}
