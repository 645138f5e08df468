package org.u2sa.flightgear.protocol;

/**
 * A line that violates the protocol. The message names the field, the value and the expectation.
 */
public final class MalformedLineException extends Exception {
  private static final long serialVersionUID = 1L;

  MalformedLineException(String message) {
    super(message);
  }
}
