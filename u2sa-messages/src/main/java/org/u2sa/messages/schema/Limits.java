package org.u2sa.messages.schema;

/**
 * Bounds that hold for what is written as for what is read, so that no sender can make a message
 * that no reader takes.
 */
final class Limits {
  static final int PAYLOAD_BYTES = 1 << 20;
  static final int TEXT_BYTES = 1 << 16;
  static final int NAME_CHARS = 255;
  static final int ID_CHARS = 1_000; // is often made of a name and a number
  static final int NOTE_CHARS = 1_000;
  static final int NOTES = 100; // of the longest, they leave room for the other fields
  static final int BYTE_STRING_BYTES = 15 << 16; // what leaves room for the other fields
  static final int LIST_ELEMENTS = 100_000;
  static final int DEPTH = 8;
  static final double NUMBER = 1e15; // its square, cube and fourth power are still numbers
  static final long TIMESTAMP_MICROS = Long.MAX_VALUE / 1_000; // year 2262; also in nanoseconds
  static final double COORDINATE = 1e9; // metres: beyond the Moon

  private Limits() {}
}
