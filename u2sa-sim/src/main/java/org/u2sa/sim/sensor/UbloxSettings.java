package org.u2sa.sim.sensor;

import java.util.EnumSet;
import java.util.Set;
import org.u2sa.sim.motion.Arguments;

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
  private static final int BITS_A_BYTE = 10;
  private static final int NMEA_BYTES = 250; // at most, of the four sentences
  private static final int UBX_BYTES = 104;

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
   * @throws IllegalArgumentException if the line does not carry that much
   */
  public static UbloxSettings precise(int baud, double rateHz) {
    return fitting(baud, rateHz, nmea(), 7, NMEA_BYTES);
  }

  /**
   * POSLLH, STATUS and VELNED, 104 bytes a position, which is all that a LEA-6 needs to say.
   *
   * @param baud 9600 carries nine positions a second
   * @throws IllegalArgumentException if the line does not carry that much
   */
  public static UbloxSettings binary(int baud, double rateHz) {
    Set<GpsMessage> messages = EnumSet.of(GpsMessage.POSLLH, GpsMessage.STATUS, GpsMessage.VELNED);
    return fitting(baud, rateHz, messages, 5, UBX_BYTES);
  }

  private static UbloxSettings fitting(
      int baud, double rateHz, Set<GpsMessage> messages, int minuteDecimals, int bytes) {
    double wanted = bytes * rateHz * BITS_A_BYTE;
    if (wanted > baud) {
      throw new IllegalArgumentException(
          "baud: "
              + baud
              + " carries less than "
              + rateHz
              + " positions of "
              + bytes
              + " bytes a second");
    }
    return new UbloxSettings(baud, rateHz, messages, minuteDecimals);
  }

  private static Set<GpsMessage> nmea() {
    return EnumSet.of(GpsMessage.GGA, GpsMessage.RMC, GpsMessage.VTG, GpsMessage.GST);
  }
}
