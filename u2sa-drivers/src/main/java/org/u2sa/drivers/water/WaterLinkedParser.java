package org.u2sa.drivers.water;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.util.OptionalDouble;
import org.u2sa.device.port.VelocityLog;
import org.u2sa.drivers.link.ByteParser;

/**
 * Parses velocity reports of Water Linked DVLs: lines {@code wrz,…} of protocol 2 and {@code wrx,…}
 * of older ones, with a CRC-8 (docs.waterlinked.com, "DVL protocol"). Its axes are x forward, y
 * right, z down.
 */
final class WaterLinkedParser extends ByteParser<VelocityLog.Speeds> {
  private static final int LONGEST = 512;
  private static final int POLYNOMIAL = 0x07;
  private static final double FASTEST_MPS = 30.0;
  private static final int HEX = 16;

  private final byte[] line = new byte[LONGEST];
  private int length;

  @Override
  public void accept(byte[] bytes, int count, long nowMicros) {
    for (int i = 0; i < count; i++) {
      byte each = bytes[i];
      if (each == '\n' || each == '\r') {
        take(nowMicros);
        length = 0;
      } else if (length < LONGEST) {
        line[length++] = each;
      }
    }
  }

  private void take(long nowMicros) {
    String text = new String(line, 0, length, US_ASCII);
    if (length == 0 || !text.startsWith("wrz,") && !text.startsWith("wrx,")) {
      return; // transducer, position and reply lines
    }
    try {
      found(speeds(text, nowMicros));
    } catch (IllegalArgumentException e) { // includes NumberFormatException
      refuse(e.getMessage() + ": " + text);
    }
  }

  private VelocityLog.Speeds speeds(String text, long nowMicros) {
    int star = text.indexOf('*');
    if (star < 0 || Integer.parseInt(text.substring(star + 1), HEX) != crc(star)) {
      throw new IllegalArgumentException("missing or wrong checksum");
    }
    String[] fields = text.substring(0, star).split(",", -1);
    boolean isNew = fields[0].equals("wrz");
    int first = isNew ? 1 : 2;
    int valid = isNew ? 4 : 7;
    if (fields.length <= valid) {
      throw new IllegalArgumentException(fields.length + " fields");
    }
    boolean isValid = fields[valid].equals("y");
    return new VelocityLog.Speeds(
        nowMicros,
        isValid ? mps(fields[first]) : OptionalDouble.empty(),
        isValid ? negative(mps(fields[first + 1])) : OptionalDouble.empty(),
        isValid ? mps(fields[first + 2]) : OptionalDouble.empty(),
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        OptionalDouble.empty());
  }

  private static OptionalDouble negative(OptionalDouble mps) {
    return OptionalDouble.of(-mps.getAsDouble());
  }

  private static OptionalDouble mps(String field) {
    double value = Double.parseDouble(field);
    if (!(Math.abs(value) <= FASTEST_MPS)) {
      throw new IllegalArgumentException("speed " + value + " m/s is outside ±" + FASTEST_MPS);
    }
    return OptionalDouble.of(value);
  }

  private int crc(int end) {
    int crc = 0;
    for (int i = 0; i < end; i++) {
      crc ^= line[i] & 0xFF;
      for (int bit = 0; bit < 8; bit++) {
        crc = ((crc & 0x80) == 0 ? crc << 1 : crc << 1 ^ POLYNOMIAL) & 0xFF;
      }
    }
    return crc;
  }

  @Override
  public void reset() {
    length = 0;
  }
}
