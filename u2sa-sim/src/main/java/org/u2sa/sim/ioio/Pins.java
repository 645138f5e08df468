package org.u2sa.sim.ioio;

/**
 * What is wired to the pins of a simulated IOIO: a vehicle with its motor controller, its GPS, its
 * receiver. The board calls it, on one thread at a time; pins are numbered as on the board.
 *
 * <p>All methods have a default that does what a pin with nothing on it does, so that a vehicle
 * says only what it has. A device sends bytes whenever it has them: the board adds the time that
 * they take on the line.
 */
public interface Pins {
  /**
   * Brings the world behind the pins to this moment. Called before the pins are read, with what
   * drives the pins unchanged since the last call.
   *
   * @param nowMicros the run's time [µs], never less than at the last call
   */
  default void advance(long nowMicros) {}

  /**
   * A pin gives these pulses from now on; {@link PulseTrain#NONE} or a width of 0: it stays low.
   *
   * @param pin a pin with a PWM module
   */
  default void driven(int pin, PulseTrain pulses) {}

  /** A digital output has this level from now on. The LED, pin 0, is lit when low. */
  default void driven(int pin, boolean high) {}

  /**
   * A pin drives nothing from now on: it is an input, or the board was reset or lost its
   * connection. A motor controller sees no more pulses.
   */
  default void released(int pin) {}

  /**
   * The board sent bytes to the device at this transmit pin of a UART.
   *
   * @param baud the UART's rate [bit/s]; the usual one if the board's divider comes near it
   * @param bytes the first {@code length} are new; the board uses the array again
   */
  default void transmitted(int pin, int baud, byte[] bytes, int length) {}

  /**
   * Takes bytes that the device at this receive pin of a UART has sent. The board asks again until
   * the answer is 0.
   *
   * @param baud the UART's rate [bit/s]; a device at another rate is not understood, and gives none
   * @param buffer where to put them
   * @return how many were put there
   */
  default int received(int pin, int baud, byte[] buffer) {
    return 0;
  }

  /** Voltage at an analog input [V]; the board measures 0…3.3 V and clips what is outside. */
  default double volts(int pin) {
    return 0.0;
  }

  /**
   * Pulses that arrive at an input, as from a radio receiver; {@link PulseTrain#NONE} if none do.
   */
  default PulseTrain pulses(int pin) {
    return PulseTrain.NONE;
  }

  /** Level of a digital input. */
  default boolean high(int pin) {
    return false;
  }
}
