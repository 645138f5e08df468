package org.u2sa.interfaces.communication;

/**
 * The Communication Manager is unreachable or rejected a request. The message names the address.
 */
public class CommunicationException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public CommunicationException(String message, Throwable cause) {
    super(message, cause);
  }

  /** Creates an exception whose message states what was tried, where, and what to do. */
  public CommunicationException(String message) {
    super(message);
  }
}
