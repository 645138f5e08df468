package org.u2sa.drivers.ioio;

/** Pin functions used here, for both boards, from the table {@code Board} of IOIOLibCore 5.07. */
enum PinFunction {
  /** Any digital output. */
  OUTPUT("a digital output"),
  /** PWM and UART transmit. */
  PERIPHERAL_OUTPUT("PWM or a UART's transmit line"),
  /** Pulse capture and UART receive. */
  PERIPHERAL_INPUT("pulse measurement or a UART's receive line"),
  /** Voltage measurement. */
  ANALOG_INPUT("an analog input");

  static final int FIRST_ANALOG = 31;
  static final int LAST_ANALOG = 46;

  private static final int INPUT_ONLY = 9;
  private static final int LAST_PIN_OTG = 46;
  private static final int LAST_PIN_V1 = 48;

  private final String words;

  PinFunction(String words) {
    this.words = words;
  }

  /** Whether an existing pin supports the function. */
  boolean isAt(int pin, boolean isOtg) {
    return switch (this) {
      case OUTPUT -> true;
      case PERIPHERAL_OUTPUT -> isPeripheral(pin, isOtg);
      case PERIPHERAL_INPUT -> pin == INPUT_ONLY || isPeripheral(pin, isOtg);
      case ANALOG_INPUT -> pin >= FIRST_ANALOG && pin <= LAST_ANALOG;
    };
  }

  /** Display name. */
  String words() {
    return words;
  }

  /** Highest pin number of a board. */
  static int lastPin(boolean isOtg) {
    return isOtg ? LAST_PIN_OTG : LAST_PIN_V1;
  }

  private static boolean isPeripheral(int pin, boolean isOtg) {
    boolean isOnBoth =
        pin >= 3 && pin <= 7
            || pin >= 10 && pin <= 14
            || pin >= 27 && pin <= 32
            || pin >= 34 && pin <= 40
            || pin == 45
            || pin == 46;
    boolean isOnOne = isOtg ? pin == 1 || pin == 2 : pin == 0 || pin == 47 || pin == 48;
    return isOnBoth || isOnOne;
  }
}
