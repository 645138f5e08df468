package org.u2sa.messages.cbor;

/**
 * The first byte of a CBOR data item (RFC 8949, 3): three bits for the major type, five for the
 * length or value.
 */
public final class Cbor {

  /** Major type 0: an unsigned integer. */
  public static final int UNSIGNED = 0x00;

  /** Major type 1: a negative integer, −1 minus the argument. */
  public static final int NEGATIVE = 0x20;

  /** Major type 2: a byte string. */
  public static final int BYTES = 0x40;

  /** Major type 3: text in UTF-8. */
  public static final int TEXT = 0x60;

  /** Major type 4: an array. */
  public static final int ARRAY = 0x80;

  /** Major type 5: a map. */
  public static final int MAP = 0xA0;

  static final int TAG = 0xC0;

  /** Mask of the major type. */
  public static final int MAJOR = 0xE0;

  /** Mask of the additional information. */
  public static final int INFO = 0x1F;

  /**
   * Additional information: the argument is in the next byte. Lower values are the argument itself.
   */
  public static final int ONE_BYTE = 24;

  /** Additional information: the argument is in the next two bytes. */
  public static final int TWO_BYTES = 25;

  static final int FOUR_BYTES = 26;

  /** Additional information: the argument is in the next eight bytes. */
  public static final int EIGHT_BYTES = 27;

  /** Additional information: {@link #BREAK} ends the item. */
  public static final int INDEFINITE = 31;

  /** False. */
  public static final int FALSE = 0xF4;

  /** True. */
  public static final int TRUE = 0xF5;

  static final int NULL = 0xF6;

  /** A number of two bytes. */
  public static final int FLOAT_16 = 0xF9;

  /** A number of four bytes. */
  public static final int FLOAT_32 = 0xFA;

  /** A number of eight bytes. */
  public static final int FLOAT_64 = 0xFB;

  /** Ends an item of indefinite length. */
  public static final int BREAK = 0xFF;

  private Cbor() {}
}
