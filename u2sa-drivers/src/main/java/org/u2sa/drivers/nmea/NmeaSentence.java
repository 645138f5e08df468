package org.u2sa.drivers.nmea;

import java.nio.charset.StandardCharsets;

/** A complete sentence delivered by {@link NmeaFramer}; valid only during that call. */
public final class NmeaSentence {
  private static final int TALKER_LETTERS = 2;

  private final byte[] bytes;
  private int length; // without checksum and line end
  private int whole; // with checksum

  NmeaSentence(byte[] bytes) {
    this.bytes = bytes;
  }

  void set(int newLength, int newWhole) {
    length = newLength;
    whole = newWhole;
  }

  /** Whether it has this type, for any talker: {@code "RMC"} for {@code $GPRMC} and $GNRMC. */
  public boolean is(String kind) {
    return hasAt(1 + TALKER_LETTERS, kind);
  }

  /** Whether it has this address, {@code "VNYMR"} for {@code $VNYMR}. */
  public boolean isAddressed(String address) {
    return hasAt(1, address);
  }

  private boolean hasAt(int from, String letters) {
    int end = from + letters.length();
    if (end > length || end < length && bytes[end] != ',') {
      return false;
    }
    for (int i = 0; i < letters.length(); i++) {
      if (bytes[from + i] != letters.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  /**
   * A field's text.
   *
   * @param index 1 is the first after the address
   */
  public String field(int index) {
    int begin = 0;
    for (int commas = 0; commas < index; begin++) {
      if (begin >= length) {
        return "";
      }
      if (bytes[begin] == ',') {
        commas++;
      }
    }
    int end = begin;
    while (end < length && bytes[end] != ',') {
      end++;
    }
    return new String(bytes, begin, end - begin, StandardCharsets.US_ASCII);
  }

  /** Full text, from the dollar sign or exclamation mark to the checksum. */
  public String text() {
    return new String(bytes, 0, whole, StandardCharsets.US_ASCII);
  }

  @Override
  public String toString() {
    return text();
  }
}
