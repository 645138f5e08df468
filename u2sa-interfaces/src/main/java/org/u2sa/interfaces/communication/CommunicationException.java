package org.u2sa.interfaces.communication;

/**
 * The Communication Manager cannot be reached or refused what was asked of it. The message names
 * the address.
 */
public class CommunicationException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** An error that says what was tried, where, and what to do. */
  public CommunicationException(String message, Throwable cause) {
    super(message, cause);
  }

  /** An error that says what was tried, where, and what to do. */
  public CommunicationException(String message) {
    super(message);
  }
}
