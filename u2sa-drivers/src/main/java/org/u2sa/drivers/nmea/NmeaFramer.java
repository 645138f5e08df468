package org.u2sa.drivers.nmea;

import java.util.function.Consumer;

/**
 * Extracts NMEA 0183 sentences from a byte stream with arbitrary boundaries and garbage. Sentences
 * with a wrong or missing checksum, truncated or too long, are rejected and counted.
 *
 * <p>Not thread-safe.
 */
final class NmeaFramer {
  /** Longer than the standard's 82 because receivers send more decimals; bounds the buffer. */
  private static final int LONGEST = 255;

  private static final int CHECKSUM_CHARACTERS = 3; // a star and two digits
  private static final int FIRST_PRINTABLE = 0x20;
  private static final int LAST_PRINTABLE = 0x7E;
  private static final int HEX = 16;

  private final byte[] bytes = new byte[LONGEST];
  private final NmeaSentence sentence = new NmeaSentence(bytes);
  private int count; // 0 while waiting for a dollar sign, or for AIS's exclamation mark
  private final Consumer<NmeaSentence> sink;
  private final Consumer<String> refusals;

  /**
   * @param sink receives complete sentences, each valid only during the call
   * @param refusals receives the reason and the text of each rejected sentence
   */
  NmeaFramer(Consumer<NmeaSentence> sink, Consumer<String> refusals) {
    this.sink = sink;
    this.refusals = refusals;
  }

  /**
   * Consumes bytes and delivers completed sentences.
   *
   * @param length number of valid bytes in {@code from}
   */
  void accept(byte[] from, int length) {
    for (int i = 0; i < length; i++) {
      accept(from[i]);
    }
  }

  private void accept(byte next) {
    if (next == '$' || next == '!' && count == 0) {
      if (count > 0) {
        refuse("cut off: ");
      }
      bytes[0] = next;
      count = 1;
    } else if (count > 0) {
      if (next == '\r' || next == '\n') {
        end();
      } else if (next < FIRST_PRINTABLE || next > LAST_PRINTABLE) {
        refuse("not text: ");
      } else if (count == LONGEST) {
        refuse("longer than " + LONGEST + " characters: ");
      } else {
        bytes[count++] = next;
      }
    }
  }

  private void end() {
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
    sink.accept(sentence);
  }

  private void refuse(String why) {
    sentence.set(count, count);
    count = 0;
    refusals.accept(why + sentence.text());
  }

  /** Discards a partial sentence. */
  void reset() {
    count = 0;
  }
}
