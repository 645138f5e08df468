package org.u2sa.sim.sensor;

import java.util.EnumSet;
import java.util.Set;
import org.u2sa.sim.motion.Arguments;

/**
 * Power-up configuration of a receiver.
 *
 * @param baud line rate [bit/s]
 * @param rateHz position rate [Hz], limited by the receiver
 * @param messages messages sent after each position
 * @param minuteDecimals decimals of an arc minute in NMEA, 5…7
 */
public record UbloxSettings(int baud, double rateHz, Set<GpsMessage> messages, int minuteDecimals) {
  private static final int FACTORY_BAUD = 9600;
  private static final int BITS_A_BYTE = 10;
  private static final int NMEA_BYTES = 250; // maximum length of the four sentences
  private static final int UBX_BYTES = 104;

  /** Copies the set. */
  public UbloxSettings {
    Arguments.requireInside("GPS rate", rateHz, 0.1, 100.0);
    Arguments.requireInside("decimals of a minute", minuteDecimals, 5, 7);
    messages = Set.copyOf(messages);
  }

  /** Factory setting: NMEA at 1 Hz and 9600 baud. */
  public static UbloxSettings factory() {
    return new UbloxSettings(FACTORY_BAUD, 1.0, nmea(), 5);
  }

  /**
   * NMEA with the full resolution of a survey receiver: 11 more characters per sentence.
   *
   * @param baud 38400 is needed for four sentences at 10 Hz
   * @throws IllegalArgumentException if the line rate is too low
   */
  public static UbloxSettings precise(int baud, double rateHz) {
    return fitting(baud, rateHz, nmea(), 7, NMEA_BYTES);
  }

  /**
   * POSLLH, STATUS and VELNED, 104 bytes per position: everything needed from a LEA-6.
   *
   * @param baud 9600 allows 9 positions per second
   * @throws IllegalArgumentException if the line rate is too low
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
              + " bytes per second");
    }
    return new UbloxSettings(baud, rateHz, messages, minuteDecimals);
  }

  private static Set<GpsMessage> nmea() {
    return EnumSet.of(GpsMessage.GGA, GpsMessage.RMC, GpsMessage.VTG, GpsMessage.GST);
  }
}
