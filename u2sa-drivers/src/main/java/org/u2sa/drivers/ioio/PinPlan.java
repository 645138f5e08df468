package org.u2sa.drivers.ioio;

import java.util.List;
import java.util.Optional;

/**
 * What is wired to which pin.
 *
 * @param pulses outputs of servo pulses
 * @param pulseHz pulses a second
 * @param gps the receiver
 * @param compass the compass
 * @param radio input of the radio's switch, {@link #NONE} if there is none
 * @param battery analog input, {@link #NONE} if there is none
 * @param sample analog input that is sampled in any case: the board's sign of life
 * @param led output of the status LED, {@link #NONE} if there is none
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
   * Where a serial device is wired.
   *
   * @param receive pin at which its bytes come
   * @param transmit pin at which bytes to it leave, {@link #NONE} if there is none
   * @param baud rate [bit/s]; 8 bits, no parity, one stop bit
   */
  record Uart(int receive, int transmit, int baud) {}
}
