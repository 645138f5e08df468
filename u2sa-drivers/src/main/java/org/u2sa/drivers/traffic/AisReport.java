package org.u2sa.drivers.traffic;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.TrafficTarget;
import org.u2sa.messages.frame.Point;

/**
 * A position report of AIS, message 1, 2 or 3 (class A) or 18 (class B), in the six-bit characters
 * of an AIVDM sentence (ITU-R M.1371-5, annex 8; IEC 61162-1).
 */
final class AisReport {
  private static final int BITS = 168;
  private static final int BITS_PER_CHARACTER = 6;
  private static final int CLASS_A_SPEED = 50; // first bit; the fields after it have the same order
  private static final int CLASS_B_SPEED = 46;
  private static final int NO_SPEED = 1023;
  private static final int NO_COURSE = 3600;
  private static final double KNOTS = 0.1;
  private static final double MPS_PER_KNOT = 1852.0 / 3600.0;
  private static final double COURSE_DEG = 0.1;
  private static final double DEGREES = 1.0 / 600_000.0;
  private static final double MAX_LONGITUDE_DEG = 180.0; // 181 and 91: not available
  private static final double MAX_LATITUDE_DEG = 90.0;

  /** Standard deviation of a report with high accuracy: 10 m at 95 %. Others give no bound. */
  private static final double ACCURATE_SIGMA_M = 10.0 / Math.sqrt(-2.0 * Math.log(0.05));

  private final String characters;

  private AisReport(String characters) {
    this.characters = characters;
  }

  /**
   * Target of a report; empty if it is another message or has no position.
   *
   * @param characters characters of the whole message
   * @throws IllegalArgumentException if it is too short or has invalid characters
   */
  static Optional<TrafficTarget> target(String characters, long nowMicros) {
    AisReport report = new AisReport(characters);
    int type = report.unsigned(0, 6);
    boolean isClassA = type >= 1 && type <= 3;
    return isClassA || type == 18
        ? report.target(isClassA ? CLASS_A_SPEED : CLASS_B_SPEED, nowMicros)
        : Optional.empty();
  }

  private Optional<TrafficTarget> target(int speedBit, long nowMicros) {
    if (characters.length() * BITS_PER_CHARACTER < BITS) {
      throw new IllegalArgumentException("a report of " + characters.length() + " characters");
    }
    double longitude = DEGREES * signed(speedBit + 11, 28);
    double latitude = DEGREES * signed(speedBit + 39, 27);
    if (Math.abs(longitude) > MAX_LONGITUDE_DEG || Math.abs(latitude) > MAX_LATITUDE_DEG) {
      return Optional.empty();
    }
    boolean isAccurate = unsigned(speedBit + 10, 1) == 1;
    return Optional.of(
        new TrafficTarget(
            String.format(Locale.ROOT, "%09d", unsigned(8, 30)),
            "",
            "vessel",
            nowMicros,
            latitude,
            longitude,
            OptionalDouble.empty(),
            false,
            velocity(unsigned(speedBit, 10), unsigned(speedBit + 66, 12)),
            isAccurate ? OptionalDouble.of(ACCURATE_SIGMA_M) : OptionalDouble.empty()));
  }

  private static Optional<Point> velocity(int speed, int course) {
    if (speed >= NO_SPEED || course >= NO_COURSE && speed != 0) {
      return Optional.empty();
    }
    double mps = KNOTS * speed * MPS_PER_KNOT;
    double track = Math.toRadians(COURSE_DEG * course);
    return Optional.of(Point.of(mps * Math.sin(track), mps * Math.cos(track), 0.0));
  }

  private int unsigned(int from, int count) {
    int value = 0;
    for (int bit = from; bit < from + count; bit++) {
      int six = six(bit / BITS_PER_CHARACTER);
      value = value << 1 | six >> (BITS_PER_CHARACTER - 1 - bit % BITS_PER_CHARACTER) & 1;
    }
    return value;
  }

  private int signed(int from, int count) {
    int value = unsigned(from, count);
    return value << (Integer.SIZE - count) >> (Integer.SIZE - count);
  }

  /** Value of a character: 0 to W are 0 to 39, a backquote to w are 40 to 63. */
  private int six(int index) {
    char character = index < characters.length() ? characters.charAt(index) : ' ';
    boolean isLow = character >= '0' && character <= 'W';
    if (!isLow && (character < '`' || character > 'w')) {
      throw new IllegalArgumentException("\"" + character + "\" is not a six-bit character");
    }
    return character - (isLow ? '0' : '8');
  }
}
