package org.u2sa.drivers.compass;

import org.u2sa.device.port.Heading;
import org.u2sa.drivers.nmea.NmeaParser;

/**
 * Sparton's SP3004D smart compass (thesis 4.6.3) and its successors DC-4, GEDC-6 and AHRS-8, in
 * their legacy binary protocol (Software Interface User's Manual 130-7524-001): {@code A4 command
 * data A0}, high byte first. It is polled: {@link #request} for the magnetic heading, answered by
 * {@code A4 09 hh hh A0}; true headings (02) are supported too. 4096 units per turn. The protocol
 * has no checksum: an answer is valid if it has the right length, ends with A0, and is below 360°.
 *
 * <p>It also parses the NMEA 0183 sentences this compass can send; no byte of a sentence can start
 * a binary answer.
 */
public final class SpartonCompass extends NmeaParser<Heading> {
  private static final int BEGIN = 0xA4;
  private static final int END = 0xA0;
  private static final int TRUE_HEADING = 0x02;
  private static final int MAGNETIC_HEADING = 0x09;
  private static final int UNITS_A_TURN = 4_096;
  private static final double DEG_PER_UNIT = 360.0 / UNITS_A_TURN;
  private static final int ANSWER = 5; // bytes

  private final byte[] one = new byte[1];
  private final int[] answer = new int[ANSWER];
  private int count;

  /** Waits for the first answer or sentence. */
  public SpartonCompass() {
    super(NmeaCompass.meaning());
  }

  /** Request for the magnetic heading. */
  public static byte[] request() {
    return new byte[] {(byte) BEGIN, MAGNETIC_HEADING, (byte) END};
  }

  @Override
  public void accept(byte[] bytes, int length, long now) {
    for (int i = 0; i < length; i++) {
      accept(bytes[i], now);
    }
  }

  private void accept(byte next, long now) {
    int octet = next & 0xFF;
    if (count == 0 && octet != BEGIN) {
      one[0] = next;
      super.accept(one, 1, now); // text
      return;
    }
    answer[count++] = octet;
    boolean isHeading = count < 2 || answer[1] == MAGNETIC_HEADING || answer[1] == TRUE_HEADING;
    if (!isHeading) {
      resync("an unrequested answer", now);
    } else if (count == ANSWER) {
      end(now);
    }
  }

  private void end(long now) {
    int units = answer[2] << 8 | answer[3];
    if (answer[ANSWER - 1] != END) {
      resync("an answer that does not end with A0", now);
    } else if (units >= UNITS_A_TURN) {
      resync("a heading of " + units + " of 4096", now);
    } else {
      found(Heading.ofDegrees(now, units * DEG_PER_UNIT, answer[1] == TRUE_HEADING));
      count = 0;
    }
  }

  /** Rejects a false answer and resynchronises from its second byte. */
  private void resync(String why, long now) {
    StringBuilder text = new StringBuilder(why).append(":");
    int[] again = new int[count - 1];
    for (int i = 0; i < count; i++) {
      text.append(String.format(" %02X", answer[i]));
      if (i > 0) {
        again[i - 1] = answer[i];
      }
    }
    refuse(text.toString());
    count = 0;
    for (int octet : again) {
      accept((byte) octet, now);
    }
  }

  @Override
  public void reset() {
    count = 0;
    super.reset();
  }
}
