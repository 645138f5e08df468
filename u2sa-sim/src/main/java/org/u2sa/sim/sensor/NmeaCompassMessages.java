package org.u2sa.sim.sensor;

/** Heading sentences of NMEA 0183, as compasses send them. */
final class NmeaCompassMessages {
  private static final double TURN_DEG = 360.0;

  private NmeaCompassMessages() {}

  /** True heading. */
  static byte[] hdt(double headingRad) {
    return new NmeaOutput("HCHDT").number(degrees(headingRad), 1, 1).text("T").bytes();
  }

  /** Magnetic heading. */
  static byte[] hdm(double headingRad) {
    return new NmeaOutput("HCHDM").number(degrees(headingRad), 1, 1).text("M").bytes();
  }

  /** Magnetic heading with the declination, which the compass was told. */
  static byte[] hdg(double headingRad, double declinationRad) {
    return new NmeaOutput("HCHDG")
        .number(degrees(headingRad), 1, 1)
        .blank(2)
        .number(Math.abs(Math.toDegrees(declinationRad)), 1, 1)
        .text(declinationRad < 0.0 ? "W" : "E")
        .bytes();
  }

  /** In 0…359.9: what rounds to 360 is 0. */
  private static double degrees(double radians) {
    double rounded = Math.round(Math.toDegrees(radians) * 10.0) / 10.0;
    return rounded >= TURN_DEG ? rounded - TURN_DEG : rounded;
  }
}
