package org.u2sa.messages.schema;

/**
 * Bounds that hold for what is written as for what is read, so that no sender can make a message
 * that no reader takes.
 */
final class Limits {
  static final int PAYLOAD_BYTES = 1 << 20;
  static final int TEXT_BYTES = 1 << 16;
  static final int BYTE_STRING_BYTES = 15 << 16; // what leaves room for the other fields
  static final int LIST_ELEMENTS = 100_000;
  static final int DEPTH = 8;

  private Limits() {}
}
