package org.u2sa.sim.ioio;

/**
 * The boards whose firmware is simulated: what they call themselves and what their pins can do.
 * From the firmware's {@code pins.c} and {@code platform.h}.
 */
public enum IoioBoard {
  /** IOIO-OTG: Bluetooth, Android accessory, and a USB serial port at a desktop. */
  OTG("SPRK0020", "IOIO0402", 47, new int[] {1, 2}),
  /** The first IOIO, which the thesis used: Bluetooth and Android accessory. */
  V1("SPRK0016", "IOIO0312", 49, new int[] {0, 47, 48});

  private static final int[][] PERIPHERALS = {{3, 7}, {10, 14}, {27, 32}, {34, 40}, {45, 46}};
  private static final int INPUT_ONLY = 9;
  // by channel of the converter, in which order its values are reported
  private static final int[] ANALOG = {
    36, 35, 34, 33, 32, 31, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46
  };

  private final String hardware;
  private final String bootloader;
  private final int pins;
  private final int[] others; // that have peripherals on this board only

  IoioBoard(String hardware, String bootloader, int pins, int[] others) {
    this.hardware = hardware;
    this.bootloader = bootloader;
    this.pins = pins;
    this.others = others;
  }

  /** What the board says its hardware is, 8 characters. */
  String hardware() {
    return hardware;
  }

  /** What the board says its boot loader is, 8 characters. */
  String bootloader() {
    return bootloader;
  }

  /** How many pins it has, the LED's pin 0 included. */
  int pins() {
    return pins;
  }

  /** Whether PWM and the transmit line of a UART can be led to a pin. */
  boolean hasPeripheralOutput(int pin) {
    for (int[] range : PERIPHERALS) {
      if (pin >= range[0] && pin <= range[1]) {
        return true;
      }
    }
    for (int other : others) {
      if (pin == other) {
        return true;
      }
    }
    return false;
  }

  /** Whether a pin can be led to the receive line of a UART and to a pulse capture. */
  boolean hasPeripheralInput(int pin) {
    return hasPeripheralOutput(pin) || pin == INPUT_ONLY;
  }

  /** Channels of the analog converter. */
  static int analogChannels() {
    return ANALOG.length;
  }

  /** The pin of a converter's channel. */
  static int analogPin(int channel) {
    return ANALOG[channel];
  }

  /** The converter's channel of a pin, −1 if it has none. */
  static int analogChannel(int pin) {
    for (int channel = 0; channel < ANALOG.length; channel++) {
      if (ANALOG[channel] == pin) {
        return channel;
      }
    }
    return -1;
  }
}
