package org.u2sa.sim.sensor;

import java.util.EnumSet;
import java.util.Set;

/**
 * What a receiver does after power-up, until it is told otherwise.
 *
 * @param baud of its line [bit/s]
 * @param rateHz positions in a second; no more than the receiver can
 * @param messages after each position
 * @param minuteDecimals of a minute of arc in NMEA, 5…7
 */
public record UbloxSettings(int baud, double rateHz, Set<GpsMessage> messages, int minuteDecimals) {
  private static final int FACTORY_BAUD = 9600;

  /** Takes a copy of the set. */
  public UbloxSettings {
    Arguments.requireInside("GPS rate", rateHz, 0.1, 100.0);
    Arguments.requireInside("decimals of a minute", minuteDecimals, 5, 7);
    messages = Set.copyOf(messages);
  }

  /** As from the factory: NMEA once a second at 9600 baud. */
  public static UbloxSettings factory() {
    return new UbloxSettings(FACTORY_BAUD, 1.0, nmea(), 5);
  }

  /**
   * NMEA with all the digits that a survey receiver has: 11 characters more a sentence.
   *
   * @param baud 38400 is needed for four sentences ten times a second
   */
  public static UbloxSettings precise(int baud, double rateHz) {
    return new UbloxSettings(baud, rateHz, nmea(), 7);
  }

  /**
   * POSLLH, STATUS and VELNED, 104 bytes a position, which is all that a LEA-6 needs to say.
   *
   * @param baud 9600 carries nine positions a second
   */
  public static UbloxSettings binary(int baud, double rateHz) {
    return new UbloxSettings(
        baud, rateHz, EnumSet.of(GpsMessage.POSLLH, GpsMessage.STATUS, GpsMessage.VELNED), 5);
  }

  private static Set<GpsMessage> nmea() {
    return EnumSet.of(GpsMessage.GGA, GpsMessage.RMC, GpsMessage.VTG, GpsMessage.GST);
  }
}
