package org.u2sa.flightgear.protocol;

/**
 * A line that is not what the protocol says. The message names the field, the value and what was
 * expected.
 */
public final class MalformedLineException extends Exception {
  private static final long serialVersionUID = 1L;

  MalformedLineException(String message) {
    super(message);
  }
}
