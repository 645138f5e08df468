package org.u2sa.messages.schema;

/**
 * The first byte of a CBOR data item (RFC 8949, 3): three bits for the major type, five for the
 * length or value.
 */
final class Cbor {
  static final int UNSIGNED = 0x00;
  static final int NEGATIVE = 0x20;
  static final int BYTES = 0x40;
  static final int TEXT = 0x60;
  static final int ARRAY = 0x80;
  static final int MAP = 0xA0;
  static final int TAG = 0xC0;
  static final int SIMPLE = 0xE0;
  static final int MAJOR = 0xE0; // mask of the major type
  static final int INFO = 0x1F; // mask of the additional information

  static final int ONE_BYTE = 24; // argument in the next byte; lower values are the argument itself
  static final int TWO_BYTES = 25;
  static final int FOUR_BYTES = 26;
  static final int EIGHT_BYTES = 27;
  static final int INDEFINITE = 31;

  static final int FALSE = 0xF4;
  static final int TRUE = 0xF5;
  static final int NULL = 0xF6;
  static final int FLOAT_16 = 0xF9;
  static final int FLOAT_32 = 0xFA;
  static final int FLOAT_64 = 0xFB;
  static final int BREAK = 0xFF; // ends items of indefinite length

  private Cbor() {}
}
