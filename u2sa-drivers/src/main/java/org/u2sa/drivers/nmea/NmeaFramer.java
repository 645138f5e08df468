package org.u2sa.drivers.nmea;

/**
 * Extracts NMEA 0183 sentences from a byte stream with arbitrary boundaries and garbage. Sentences
 * with a wrong or missing checksum, truncated or too long, are rejected and counted.
 *
 * <p>Not thread-safe.
 */
public final class NmeaFramer {
  /** Longer than the standard's 82 because receivers send more decimals; bounds the buffer. */
  private static final int LONGEST = 255;

  private static final int CHECKSUM_CHARACTERS = 3; // a star and two digits
  private static final int FIRST_PRINTABLE = 0x20;
  private static final int LAST_PRINTABLE = 0x7E;
  private static final int HEX = 16;

  private final byte[] bytes = new byte[LONGEST];
  private final NmeaSentence sentence = new NmeaSentence(bytes);
  private int count; // 0 while waiting for a dollar sign
  private long refused;
  private String lastRefusal = "";

  /** Receives sentences. */
  @FunctionalInterface
  public interface Sink {
    /** Handles a sentence; its bytes are valid only during this call. */
    void sentence(NmeaSentence sentence);
  }

  /**
   * Consumes bytes and delivers completed sentences.
   *
   * @param length number of valid bytes in {@code from}
   */
  public void accept(byte[] from, int length, Sink sink) {
    for (int i = 0; i < length; i++) {
      accept(from[i], sink);
    }
  }

  private void accept(byte next, Sink sink) {
    if (next == '$') {
      if (count > 0) {
        refuse("cut off: ");
      }
      bytes[0] = next;
      count = 1;
    } else if (count > 0) {
      if (next == '\r' || next == '\n') {
        end(sink);
      } else if (next < FIRST_PRINTABLE || next > LAST_PRINTABLE) {
        refuse("not text: ");
      } else if (count == LONGEST) {
        refuse("longer than " + LONGEST + " characters: ");
      } else {
        bytes[count++] = next;
      }
    }
  }

  private void end(Sink sink) {
    int star = count - CHECKSUM_CHARACTERS;
    if (star < 1 || bytes[star] != '*') {
      refuse("no checksum: ");
      return;
    }
    int sum = 0;
    for (int i = 1; i < star; i++) {
      sum ^= bytes[i];
    }
    int said = HEX * Character.digit(bytes[star + 1], HEX) + Character.digit(bytes[star + 2], HEX);
    if (sum != said) {
      refuse("wrong checksum: ");
      return;
    }
    sentence.set(star, count);
    count = 0;
    sink.sentence(sentence);
  }

  private void refuse(String why) {
    sentence.set(count, count);
    count = 0;
    refused++;
    lastRefusal = why + sentence.text();
  }

  /** Discards a partial sentence. */
  public void reset() {
    count = 0;
  }

  /** Number of sentences rejected. */
  public long refused() {
    return refused;
  }

  /** Reason and text of the last rejection; empty if none. */
  public String lastRefusal() {
    return lastRefusal;
  }
}
