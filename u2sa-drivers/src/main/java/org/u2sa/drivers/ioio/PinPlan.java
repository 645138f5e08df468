package org.u2sa.drivers.ioio;

import java.util.List;
import java.util.Optional;

/**
 * Pin assignment.
 *
 * @param pulses servo pulse outputs
 * @param pulseHz pulse rate [Hz]
 * @param gps the receiver
 * @param compass the compass
 * @param radio radio switch input, or {@link #NONE}
 * @param battery battery analog input, or {@link #NONE}
 * @param sample analog input that is always sampled, as the board's heartbeat
 * @param led status LED output, or {@link #NONE}
 */
record PinPlan(
    List<Integer> pulses,
    int pulseHz,
    Optional<Uart> gps,
    Optional<Uart> compass,
    int radio,
    int battery,
    int sample,
    int led) {
  static final int NONE = -1;

  /**
   * Wiring of a serial device.
   *
   * @param receive RX pin
   * @param transmit TX pin, or {@link #NONE}
   * @param baud rate [bit/s]; 8 bits, no parity, one stop bit
   */
  record Uart(int receive, int transmit, int baud) {}
}
