package org.u2sa.sim.ioio;

/**
 * Hardware wired to the pins of a simulated IOIO: a vehicle with motor controller, GPS and
 * receiver. Called by the board from one thread at a time; pin numbers are the board's.
 *
 * <p>Default methods model an unconnected pin, so implementations override only what they use.
 * Devices may send bytes at any time: the board models line delay.
 */
public interface Pins {
  /**
   * Advances the hardware to this time. Called before the pins are read; outputs are constant since
   * the previous call.
   *
   * @param nowMicros time of the run [µs], non-decreasing
   */
  default void advance(long nowMicros) {}

  /**
   * A pin outputs these pulses from now on; {@link PulseTrain#NONE} or a width of 0 keeps it low.
   *
   * @param pin a pin with a PWM module
   */
  default void driven(int pin, PulseTrain pulses) {}

  /** Sets a digital output. The LED, pin 0, is lit when low. */
  default void driven(int pin, boolean high) {}

  /**
   * A pin stops driving: it became an input, or the board was reset or disconnected. A motor
   * controller receives no more pulses.
   */
  default void released(int pin) {}

  /**
   * The board sent bytes to the device at this transmit pin of a UART.
   *
   * @param baud the UART's rate [bit/s], rounded to the standard rate if the board's divider is
   *     close to it
   * @param bytes the first {@code length} are valid; the array is reused
   */
  default void transmitted(int pin, int baud, byte[] bytes, int length) {}

  /**
   * Reads bytes sent by the device at this UART receive pin. Called repeatedly until it returns 0.
   *
   * @param baud the UART's rate [bit/s]; a device at another rate returns none
   * @param buffer destination
   * @return number of bytes
   */
  default int received(int pin, int baud, byte[] buffer) {
    return 0;
  }

  /** Voltage at an analog input [V]; the board clips to 0…3.3 V. */
  default double volts(int pin) {
    return 0.0;
  }

  /** Pulses at an input, such as from a radio receiver; {@link PulseTrain#NONE} for none. */
  default PulseTrain pulses(int pin) {
    return PulseTrain.NONE;
  }

  /** Level of a digital input. */
  default boolean high(int pin) {
    return false;
  }
}
