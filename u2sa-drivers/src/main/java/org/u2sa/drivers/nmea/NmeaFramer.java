package org.u2sa.drivers.nmea;

/**
 * Finds NMEA 0183 sentences in a stream of bytes that may be cut anywhere and be garbage. Those
 * with a wrong checksum or none, that are cut off or too long are refused and counted.
 *
 * <p>For one thread.
 */
public final class NmeaFramer {
  /** Longer than the standard's 82, since receivers write more decimals; bounds what is kept. */
  private static final int LONGEST = 255;

  private static final int CHECKSUM_CHARACTERS = 3; // a star and two digits
  private static final int FIRST_PRINTABLE = 0x20;
  private static final int LAST_PRINTABLE = 0x7E;
  private static final int HEX = 16;

  private final byte[] bytes = new byte[LONGEST];
  private final NmeaSentence sentence = new NmeaSentence(bytes);
  private int count; // 0: waits for a dollar
  private long refused;
  private String lastRefusal = "";

  /** Takes sentences. */
  @FunctionalInterface
  public interface Sink {
    /** Takes one; its bytes count during this call only. */
    void sentence(NmeaSentence sentence);
  }

  /**
   * Takes the next bytes of the stream, and hands the sentences that they end over.
   *
   * @param length how many of {@code from} count, from the beginning
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

  /** Forgets what is half received. */
  public void reset() {
    count = 0;
  }

  /** How many sentences were refused so far. */
  public long refused() {
    return refused;
  }

  /** Why, and which, the last time; empty if none was. */
  public String lastRefusal() {
    return lastRefusal;
  }
}
