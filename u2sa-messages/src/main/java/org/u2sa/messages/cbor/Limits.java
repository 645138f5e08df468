package org.u2sa.messages.cbor;

/**
 * Bounds for both writing and reading, so that no sender can produce a message that readers reject.
 */
public final class Limits {
  /** Bytes of a message. */
  public static final int PAYLOAD_BYTES = 1 << 20;

  /** Bytes of a text in UTF-8. */
  public static final int TEXT_BYTES = 1 << 16;

  /** Characters of a name. */
  public static final int NAME_CHARS = 255;

  /** Characters of an identifier, which is often composed of a name and a number. */
  public static final int ID_CHARS = 1_000;

  /** Characters of a note. */
  public static final int NOTE_CHARS = 1_000;

  /** Notes in a list: even of maximum length, they leave room for other fields. */
  public static final int NOTES = 100;

  /** Bytes of a byte string; leaves room for other fields. */
  public static final int BYTE_STRING_BYTES = 15 << 16;

  /** Elements of a list. */
  public static final int LIST_ELEMENTS = 100_000;

  /** Nested messages. */
  public static final int DEPTH = 8;

  /** Magnitude of a number: its fourth power is still finite. */
  public static final double NUMBER = 1e15;

  /** Timestamp [µs]: year 2262, also in nanoseconds. */
  public static final long TIMESTAMP_MICROS = Long.MAX_VALUE / 1_000;

  /** Magnitude of a coordinate [m]: beyond the Moon. */
  public static final double COORDINATE = 1e9;

  private Limits() {}

  /** Checks that a coordinate's square is finite, so that calculations with it stay finite. */
  public static void requireCoordinate(double coordinate) {
    if (Math.abs(coordinate) > COORDINATE) {
      throw expected("coordinates of at most " + COORDINATE + ", not " + coordinate);
    }
  }

  /** Error for an unexpected value. */
  public static IllegalArgumentException expected(String what) {
    return new IllegalArgumentException("expected " + what);
  }
}
