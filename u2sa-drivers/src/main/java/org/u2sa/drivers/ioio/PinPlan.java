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
    Optional<UartPins> gps,
    Optional<UartPins> compass,
    int radio,
    int battery,
    int sample,
    int led) {
  static final int NONE = -1;
}
