package org.u2sa.drivers.traffic;

import java.util.Arrays;
import java.util.Optional;
import org.u2sa.device.port.TrafficPicture;
import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.drivers.link.ByteParser;

/**
 * Extracts GDL 90 messages from a byte stream and maintains the traffic picture (Garmin, GDL 90
 * Data Interface Specification, 560-1058-00 Rev A, chapter 2): between two flags 7E, 7D before an
 * escaped byte, and a CRC with its low byte first.
 */
final class Gdl90Parser extends ByteParser<TrafficReceiver.Traffic> {
  private static final int FLAG = 0x7E;
  private static final int ESCAPE = 0x7D;
  private static final int ESCAPED = 0x20;
  private static final int POLYNOMIAL = 0x1021;
  private static final int CRC_BYTES = 2;
  private static final int LONGEST = 1_024; // uplink data has 436 bytes
  private static final int HEARTBEAT = 0;
  private static final int TRAFFIC_REPORT = 20;

  private final TrafficPicture picture = new TrafficPicture();
  private final byte[] message = new byte[LONGEST];
  private int length;
  private boolean isEscaped;
  private boolean isInside; // after a flag byte

  @Override
  public void accept(byte[] bytes, int count, long nowMicros) {
    for (int i = 0; i < count; i++) {
      accept(bytes[i] & 0xFF, nowMicros);
    }
  }

  private void accept(int each, long nowMicros) {
    if (each == FLAG) {
      if (isInside && length > 0) {
        take(nowMicros);
      }
      isInside = true;
      length = 0;
      isEscaped = false;
    } else if (each == ESCAPE) {
      isEscaped = true;
    } else if (length < LONGEST) {
      message[length++] = (byte) (isEscaped ? each ^ ESCAPED : each);
      isEscaped = false;
    }
  }

  private void take(long nowMicros) {
    int end = length - CRC_BYTES;
    int said = end < 1 ? -1 : (message[end + 1] & 0xFF) << 8 | message[end] & 0xFF;
    if (said != crc(message, end)) {
      refuse("a message of " + length + " bytes with a wrong checksum");
      return;
    }
    if (message[0] == HEARTBEAT) {
      picture.alive(nowMicros);
    } else if (message[0] == TRAFFIC_REPORT) {
      report(Arrays.copyOf(message, end), nowMicros);
    }
  }

  private void report(byte[] report, long nowMicros) {
    try {
      Gdl90Report.target(report, nowMicros).ifPresent(target -> picture.heard(target, nowMicros));
    } catch (IllegalArgumentException e) {
      refuse(e.getMessage());
    }
  }

  /** CRC of section 2.2.3, which, unlike others, feeds in each byte at the low end. */
  static int crc(byte[] bytes, int end) {
    int crc = 0;
    for (int i = 0; i < end; i++) {
      int high = crc & 0xFF00;
      for (int bit = 0; bit < 8; bit++) {
        high = (high & 0x8000) == 0 ? high << 1 : high << 1 ^ POLYNOMIAL;
      }
      crc = (high ^ crc << 8 ^ bytes[i] & 0xFF) & 0xFFFF;
    }
    return crc;
  }

  @Override
  public void reset() {
    isInside = false;
    length = 0;
    isEscaped = false;
  }

  @Override
  public Optional<TrafficReceiver.Traffic> latest() {
    return picture.latest();
  }
}
