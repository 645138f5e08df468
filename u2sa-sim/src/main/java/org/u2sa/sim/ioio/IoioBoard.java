package org.u2sa.sim.ioio;

/**
 * The simulated boards: identification and pin capabilities. After the firmware's {@code pins.c}
 * and {@code platform.h}.
 */
public enum IoioBoard {
  /** IOIO-OTG: Bluetooth, Android accessory, and a USB serial port at a desktop. */
  OTG("SPRK0020", "IOIO0402", 47, new int[] {1, 2}),
  /** The original IOIO used in the thesis: Bluetooth and Android accessory. */
  V1("SPRK0016", "IOIO0312", 49, new int[] {0, 47, 48});

  private static final int[][] PERIPHERALS = {{3, 7}, {10, 14}, {27, 32}, {34, 40}, {45, 46}};
  private static final int INPUT_ONLY = 9;
  // pins by converter channel, the order in which values are reported
  private static final int[] ANALOG = {
    36, 35, 34, 33, 32, 31, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46
  };

  private final String hardware;
  private final String bootloader;
  private final int pins;
  private final int[] others; // pins with peripherals on this board only

  IoioBoard(String hardware, String bootloader, int pins, int[] others) {
    this.hardware = hardware;
    this.bootloader = bootloader;
    this.pins = pins;
    this.others = others;
  }

  /** Hardware identifier, 8 characters. */
  String hardware() {
    return hardware;
  }

  /** Boot-loader identifier, 8 characters. */
  String bootloader() {
    return bootloader;
  }

  /** Number of pins, including the LED (pin 0). */
  int pins() {
    return pins;
  }

  /** Whether a pin supports PWM and UART transmit. */
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

  /** Whether a pin supports UART receive and pulse capture. */
  boolean hasPeripheralInput(int pin) {
    return hasPeripheralOutput(pin) || pin == INPUT_ONLY;
  }

  /** Number of analog channels. */
  static int analogChannels() {
    return ANALOG.length;
  }

  static int analogPin(int channel) {
    return ANALOG[channel];
  }

  /** Analog channel of a pin, −1 if none. */
  static int analogChannel(int pin) {
    for (int channel = 0; channel < ANALOG.length; channel++) {
      if (ANALOG[channel] == pin) {
        return channel;
      }
    }
    return -1;
  }
}
