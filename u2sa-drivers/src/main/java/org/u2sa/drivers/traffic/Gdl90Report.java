package org.u2sa.drivers.traffic;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.TrafficTarget;
import org.u2sa.messages.frame.Point;

/**
 * A traffic report, message 20 (GDL 90 Data Interface Specification, section 3.5): 28 bytes,
 * big-endian.
 */
final class Gdl90Report {
  private static final int BYTES = 28;
  private static final double DEGREES = 180.0 / (1 << 23);
  private static final double METRES_PER_FOOT = 0.3048;
  private static final double MPS_PER_KNOT = 1852.0 / 3600.0;
  private static final double ALTITUDE_STEP_FT = 25.0;
  private static final double ALTITUDE_OFFSET_FT = 1000.0;
  private static final int NO_ALTITUDE = 0xFFF;
  private static final int NO_SPEED = 0xFFF;
  private static final int NO_CLIMB = 0x800;
  private static final double CLIMB_STEP_FPM = 64.0;
  private static final double S_PER_MINUTE = 60.0;
  private static final double TRACK_STEP_RAD = 2.0 * Math.PI / 256.0;
  private static final int TRACK_TYPE = 0x3;
  private static final int TRUE_TRACK = 1;
  private static final double MAX_LATITUDE_DEG = 90.0;

  /** 95 % position radius by NACp, 1 to 11 [m] (table 12; DO-260B). */
  private static final double[] NACP_M = {
    18_520, 7_408, 3_704, 1_852, 926, 555.6, 185.2, 92.6, 30, 10, 3
  };

  private static final double RADIUS_PER_SIGMA = Math.sqrt(-2.0 * Math.log(0.05)); // Rayleigh

  private Gdl90Report() {}

  /**
   * Target of a report; empty if its position is invalid.
   *
   * @param report report starting at the message ID, without checksum
   * @throws IllegalArgumentException if its length or coordinates are invalid
   */
  static Optional<TrafficTarget> target(byte[] report, long nowMicros) {
    if (report.length != BYTES) {
      throw new IllegalArgumentException("a traffic report of " + report.length + " bytes");
    }
    int latitude = signed24(report, 5);
    int longitude = signed24(report, 8);
    int integrity = unsigned(report, 13) >> 4;
    if (latitude == 0 && longitude == 0 && integrity == 0) {
      return Optional.empty();
    }
    if (Math.abs(latitude * DEGREES) > MAX_LATITUDE_DEG) {
      throw new IllegalArgumentException(
          String.format(Locale.ROOT, "latitude %.5f is outside ±90 deg", latitude * DEGREES));
    }
    int altitude = unsigned(report, 11) << 4 | unsigned(report, 12) >> 4;
    return Optional.of(
        new TrafficTarget(
            id(report),
            new String(report, 19, 8, US_ASCII).trim(),
            "aircraft",
            nowMicros,
            latitude * DEGREES,
            longitude * DEGREES,
            altitude == NO_ALTITUDE
                ? OptionalDouble.empty()
                : OptionalDouble.of(
                    (altitude * ALTITUDE_STEP_FT - ALTITUDE_OFFSET_FT) * METRES_PER_FOOT),
            true,
            velocity(report),
            sigmaM(unsigned(report, 13) & 0xF)));
  }

  /** ICAO address; other address types are prefixed with their type. */
  private static String id(byte[] report) {
    int type = unsigned(report, 1) & 0xF;
    boolean isIcao = type == 0 || type == 2;
    String address =
        String.format(
            Locale.ROOT,
            "%02X%02X%02X",
            unsigned(report, 2),
            unsigned(report, 3),
            unsigned(report, 4));
    return isIcao ? address : type + "-" + address;
  }

  /** Empty without a speed or ground track; a heading does not count as track. */
  private static Optional<Point> velocity(byte[] report) {
    int speed = unsigned(report, 14) << 4 | unsigned(report, 15) >> 4;
    int climb = (unsigned(report, 15) & 0xF) << 8 | unsigned(report, 16);
    boolean hasTrack = (unsigned(report, 12) & TRACK_TYPE) == TRUE_TRACK;
    if (speed == NO_SPEED || !hasTrack && speed != 0) {
      return Optional.empty();
    }
    double mps = speed * MPS_PER_KNOT;
    double track = unsigned(report, 17) * TRACK_STEP_RAD;
    int climbSteps = climb >= NO_CLIMB ? climb - 2 * NO_CLIMB : climb;
    double upMps =
        climb == NO_CLIMB ? 0.0 : climbSteps * CLIMB_STEP_FPM * METRES_PER_FOOT / S_PER_MINUTE;
    return Optional.of(Point.of(mps * Math.sin(track), mps * Math.cos(track), upMps));
  }

  private static OptionalDouble sigmaM(int accuracy) {
    return accuracy == 0 || accuracy > NACP_M.length
        ? OptionalDouble.empty()
        : OptionalDouble.of(NACP_M[accuracy - 1] / RADIUS_PER_SIGMA);
  }

  private static int unsigned(byte[] report, int at) {
    return report[at] & 0xFF;
  }

  private static int signed24(byte[] report, int at) {
    return report[at] << 16 | unsigned(report, at + 1) << 8 | unsigned(report, at + 2);
  }
}
