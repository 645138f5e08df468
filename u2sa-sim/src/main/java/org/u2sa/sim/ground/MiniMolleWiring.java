package org.u2sa.sim.ground;

/**
 * Which pin of the IOIO leads where, and how the battery is divided down. The board receives at
 * {@code …Receive} what the device sends.
 *
 * @param first pulses to the left motor's controller, or to that of the only motor
 * @param second pulses to the right motor's controller, or to the steering servo
 * @param radioSwitch pulses of the radio receiver's switch channel
 * @param battery analog input
 * @param dividerRatio voltage at that input by the battery's
 */
public record MiniMolleWiring(
    int gpsReceive,
    int gpsTransmit,
    int compassReceive,
    int compassTransmit,
    int first,
    int second,
    int radioSwitch,
    int battery,
    double dividerRatio) {
  /** The wiring of docs/drivers: GPS 6 and 7, compass 13 and 14, motors 10 and 11, 35, 40. */
  public static MiniMolleWiring standard() {
    return new MiniMolleWiring(6, 7, 13, 14, 10, 11, 35, 40, 0.2);
  }
}
