package org.u2sa.sim.sensor;

import java.time.LocalDateTime;

/**
 * UBX navigation messages: POSLLH, STATUS, SOL and VELNED of the u-blox 6 Receiver Description
 * (GPS.G6-SW-10018), PVT of the u-blox 8 / M8 Receiver Description (UBX-13003221).
 */
final class UbxGpsMessages {
  static final int NAV = 0x01;
  static final int POSLLH = 0x02;
  static final int STATUS = 0x03;
  static final int SOL = 0x06;
  static final int PVT = 0x07;
  static final int VELNED = 0x12;

  private static final double E7 = 1e7;
  private static final double MM = 1e3;
  private static final double CM = 1e2;
  private static final int FIX_3D = 3;
  private static final double WGS84_A_M = 6_378_137.0;
  private static final double WGS84_E2 = 6.69437999014e-3;
  private static final long UNKNOWN_ACCURACY = 0xFFFFFFFFL;

  private final UtcTime utc;

  UbxGpsMessages(UtcTime utc) {
    this.utc = utc;
  }

  /** Position and its accuracy. */
  byte[] posllh(GpsSample s) {
    return new UbxMessage(NAV, POSLLH, 28)
        .i4(utc.timeOfWeekMs(s.timeS()))
        .i4(s.longitudeDeg(), E7)
        .i4(s.latitudeDeg(), E7)
        .i4(s.altitudeM(), MM)
        .i4(s.altitudeM(), MM)
        .i4(accuracy(s, horizontalM(s), MM))
        .i4(accuracy(s, s.verticalSigmaM(), MM))
        .bytes();
  }

  /** Fix type. */
  byte[] status(GpsSample s) {
    return new UbxMessage(NAV, STATUS, 16)
        .i4(utc.timeOfWeekMs(s.timeS()))
        .u1(fix(s))
        .u1(flags(s))
        .u1(s.quality() > 1 ? 1 : 0)
        .u1(0)
        .i4(s.valid() ? 25_000 : 0) // time to the first fix
        .i4(Math.round(s.timeS() * MM))
        .bytes();
  }

  /** Velocity and its accuracy. */
  byte[] velned(GpsSample s) {
    double up2 = s.upMps() * s.upMps();
    double speed3d = StrictMath.sqrt(s.speedMps() * s.speedMps() + up2);
    return new UbxMessage(NAV, VELNED, 36)
        .i4(utc.timeOfWeekMs(s.timeS()))
        .i4(s.northMps(), CM)
        .i4(s.eastMps(), CM)
        .i4(-s.upMps(), CM)
        .i4(speed3d, CM)
        .i4(s.speedMps(), CM)
        .i4(s.courseDeg(), 1e5)
        .i4(accuracy(s, s.velocitySigmaMps(), CM))
        .i4(2.0, 1e5) // of the course
        .bytes();
  }

  /** Position, velocity and time in one message. */
  byte[] pvt(GpsSample s) {
    LocalDateTime time = utc.at(s.timeS());
    return new UbxMessage(NAV, PVT, 92)
        .i4(utc.timeOfWeekMs(s.timeS()))
        .u2(time.getYear())
        .u1(time.getMonthValue())
        .u1(time.getDayOfMonth())
        .u1(time.getHour())
        .u1(time.getMinute())
        .u1(time.getSecond())
        .u1(0x07) // date and time valid, fully resolved
        .i4(30) // time accuracy [ns]
        .i4(time.getNano())
        .u1(fix(s))
        .u1(carrier(s) | (s.valid() ? 1 : 0))
        .u1(0)
        .u1(s.satellites())
        .i4(s.longitudeDeg(), E7)
        .i4(s.latitudeDeg(), E7)
        .i4(s.altitudeM(), MM)
        .i4(s.altitudeM(), MM)
        .i4(accuracy(s, horizontalM(s), MM))
        .i4(accuracy(s, s.verticalSigmaM(), MM))
        .i4(s.northMps(), MM)
        .i4(s.eastMps(), MM)
        .i4(-s.upMps(), MM)
        .i4(s.speedMps(), MM)
        .i4(s.courseDeg(), 1e5)
        .i4(accuracy(s, s.velocitySigmaMps(), MM))
        .i4(2.0, 1e5) // of the course
        .u2(s.valid() ? 150 : 9999) // PDOP
        .skip(14) // flags 3, reserved, heading of vehicle, declination and its accuracy
        .bytes();
  }

  /** Fix type, satellites, ECEF position and velocity. */
  byte[] sol(GpsSample s) {
    double latitude = StrictMath.toRadians(s.latitudeDeg());
    double longitude = StrictMath.toRadians(s.longitudeDeg());
    double sinLat = StrictMath.sin(latitude);
    double cosLat = StrictMath.cos(latitude);
    double sinLon = StrictMath.sin(longitude);
    double cosLon = StrictMath.cos(longitude);
    double n = WGS84_A_M / StrictMath.sqrt(1.0 - WGS84_E2 * sinLat * sinLat);
    double outward = (n + s.altitudeM()) * cosLat;
    double away = s.upMps() * cosLat - s.northMps() * sinLat; // velocity away from the earth's axis
    double share = s.valid() ? 1.0 : 0.0; // all zeros without a fix
    long timeMs = utc.timeOfWeekMs(s.timeS());
    return new UbxMessage(NAV, SOL, 52)
        .i4(timeMs)
        .i4(0) // remainder below a millisecond [ns]
        .u2(utc.week(s.timeS()))
        .u1(fix(s))
        .u1(flags(s))
        .i4(share * outward * cosLon, CM)
        .i4(share * outward * sinLon, CM)
        .i4(share * (n * (1.0 - WGS84_E2) + s.altitudeM()) * sinLat, CM)
        .i4(accuracy(s, position3dM(s), CM))
        .i4(share * (away * cosLon - s.eastMps() * sinLon), CM)
        .i4(share * (away * sinLon + s.eastMps() * cosLon), CM)
        .i4(share * (s.northMps() * cosLat + s.upMps() * sinLat), CM)
        .i4(accuracy(s, s.velocitySigmaMps(), CM))
        .u2(s.valid() ? 150 : 9999) // PDOP
        .u1(0)
        .u1(s.satellites())
        .i4(0)
        .bytes();
  }

  /** Fix, differential, week and time of week known. */
  private static int flags(GpsSample s) {
    return s.valid() ? 0xD | (s.quality() > 1 ? 2 : 0) : 0xC;
  }

  private static int fix(GpsSample s) {
    return s.valid() ? FIX_3D : 0;
  }

  /** Carrier phase solution: 2 fixed, 1 floating, in the two upper bits; and differential. */
  private static int carrier(GpsSample s) {
    return switch (s.quality()) {
      case 4 -> 0x82;
      case 5 -> 0x42;
      case 2 -> 0x02;
      default -> 0;
    };
  }

  /** Error of both axes combined, as reported by receivers. */
  private static double horizontalM(GpsSample s) {
    return StrictMath.sqrt(2.0) * s.horizontalSigmaM();
  }

  private static double position3dM(GpsSample s) {
    double horizontal = horizontalM(s);
    return StrictMath.sqrt(horizontal * horizontal + s.verticalSigmaM() * s.verticalSigmaM());
  }

  private static long accuracy(GpsSample s, double value, double scale) {
    return s.valid() ? Math.round(value * scale) : UNKNOWN_ACCURACY;
  }
}
