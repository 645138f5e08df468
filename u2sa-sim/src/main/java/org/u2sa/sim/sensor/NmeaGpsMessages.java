package org.u2sa.sim.sensor;

import java.time.LocalDateTime;

/**
 * The NMEA 0183 sentences of a u-blox receiver (u-blox 6 Receiver Description, NMEA protocol
 * version 2.3). Without a fix, fields are empty, as with real receivers. The geoid is taken equal
 * to the ellipsoid, as everywhere in U2SA.
 */
final class NmeaGpsMessages {
  private static final double KNOTS_PER_MPS = 3600.0 / 1852.0;
  private static final double KMH_PER_MPS = 3.6;

  private final UtcTime utc;
  private final int minuteDecimals;

  /**
   * @param minuteDecimals decimals of an arc minute: 5 (1.9 cm) for u-blox receivers, 7 in their
   *     high-precision mode
   */
  NmeaGpsMessages(UtcTime utc, int minuteDecimals) {
    this.utc = utc;
    this.minuteDecimals = minuteDecimals;
  }

  /** Position, quality and altitude. */
  byte[] gga(GpsSample s) {
    NmeaOutput sentence = new NmeaOutput("GPGGA").timeOfDay(utc.at(s.timeS()));
    if (!s.valid()) {
      return sentence.blank(4).text("0").text("00").text("99.99").blank(6).bytes();
    }
    return place(sentence, s)
        .text(Integer.toString(s.quality()))
        .number(Math.min(12, s.satellites()), 2, 0)
        .number(dilution(s), 1, 2)
        .number(s.altitudeM(), 1, 3)
        .text("M")
        .text("0.0")
        .text("M")
        .blank(2)
        .bytes();
  }

  /** Position, speed, course and date. */
  byte[] rmc(GpsSample s) {
    LocalDateTime time = utc.at(s.timeS());
    NmeaOutput sentence = new NmeaOutput("GPRMC").timeOfDay(time);
    if (!s.valid()) {
      return sentence.text("V").blank(6).date(time).blank(2).text("N").bytes();
    }
    return place(sentence.text("A"), s)
        .number(s.speedMps() * KNOTS_PER_MPS, 1, 3)
        .number(courseDeg(s), 1, 2)
        .date(time)
        .blank(2)
        .text(mode(s))
        .bytes();
  }

  /** Course and speed. */
  byte[] vtg(GpsSample s) {
    NmeaOutput sentence = new NmeaOutput("GPVTG");
    if (!s.valid()) {
      return sentence.blank(8).text("N").bytes();
    }
    return sentence
        .number(courseDeg(s), 1, 2)
        .text("T")
        .blank(1)
        .text("M")
        .number(s.speedMps() * KNOTS_PER_MPS, 1, 3)
        .text("N")
        .number(s.speedMps() * KMH_PER_MPS, 1, 3)
        .text("K")
        .text(mode(s))
        .bytes();
  }

  /** Standard deviations of latitude, longitude and altitude. */
  byte[] gst(GpsSample s) {
    NmeaOutput sentence = new NmeaOutput("GPGST").timeOfDay(utc.at(s.timeS()));
    if (!s.valid()) {
      return sentence.blank(7).bytes();
    }
    return sentence
        .number(s.horizontalSigmaM(), 1, 3) // range residual RMS: same magnitude
        .blank(3)
        .number(s.horizontalSigmaM(), 1, 3)
        .number(s.horizontalSigmaM(), 1, 3)
        .number(s.verticalSigmaM(), 1, 3)
        .bytes();
  }

  private NmeaOutput place(NmeaOutput sentence, GpsSample s) {
    return sentence
        .angle(s.latitudeDeg(), 2, minuteDecimals, "N", "S")
        .angle(s.longitudeDeg(), 3, minuteDecimals, "E", "W");
  }

  /** Normalises to 0…359.99; values that round to 360 become 0. */
  private static double courseDeg(GpsSample s) {
    double course = s.courseDeg();
    return course >= 359.995 ? 0.0 : course;
  }

  private static String mode(GpsSample s) {
    return switch (s.quality()) {
      case 2 -> "D";
      case 4 -> "R";
      case 5 -> "F";
      default -> "A";
    };
  }

  /** Typical HDOP for a number of satellites. */
  static double dilution(GpsSample s) {
    return s.satellites() >= 12 ? 0.8 : 1.2;
  }
}
