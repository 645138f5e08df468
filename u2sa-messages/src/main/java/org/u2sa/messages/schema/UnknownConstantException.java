package org.u2sa.messages.schema;

/** A constant of an enum that a later version of the data model has and this reader does not. */
final class UnknownConstantException extends IllegalArgumentException {
  private static final long serialVersionUID = 1L;

  UnknownConstantException(String message) {
    super(message);
  }
}
