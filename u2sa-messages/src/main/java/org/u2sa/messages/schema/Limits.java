package org.u2sa.messages.schema;

/**
 * Bounds for both writing and reading, so that no sender can produce a message that readers reject.
 */
final class Limits {
  static final int PAYLOAD_BYTES = 1 << 20;
  static final int TEXT_BYTES = 1 << 16;
  static final int NAME_CHARS = 255;
  static final int ID_CHARS = 1_000; // often composed of a name and a number
  static final int NOTE_CHARS = 1_000;
  static final int NOTES = 100; // even of maximum length, leaves room for other fields
  static final int BYTE_STRING_BYTES = 15 << 16; // leaves room for other fields
  static final int LIST_ELEMENTS = 100_000;
  static final int DEPTH = 8;
  static final double NUMBER = 1e15; // its fourth power is still finite
  static final long TIMESTAMP_MICROS = Long.MAX_VALUE / 1_000; // year 2262; also in nanoseconds
  static final double COORDINATE = 1e9; // metres: beyond the Moon

  private Limits() {}
}
