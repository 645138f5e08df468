package org.u2sa.sim.ioio;

import java.util.Arrays;

/**
 * IOIO protocol message types and the length of their fixed part. After the firmware's {@code
 * protocol_defs.h}; the same number has different meanings to and from the board.
 */
final class Message {
  static final int HARD_RESET = 0x00;
  static final int ESTABLISH_CONNECTION = 0x00;
  static final int SOFT_RESET = 0x01;
  static final int CHECK_INTERFACE = 0x02;
  static final int CHECK_INTERFACE_RESPONSE = 0x02;
  static final int SET_PIN_DIGITAL_OUT = 0x03;
  static final int SET_DIGITAL_OUT_LEVEL = 0x04;
  static final int REPORT_DIGITAL_IN_STATUS = 0x04;
  static final int SET_PIN_DIGITAL_IN = 0x05;
  static final int SET_CHANGE_NOTIFY = 0x06;
  static final int SET_PIN_PWM = 0x08;
  static final int SET_PWM_DUTY_CYCLE = 0x09;
  static final int SET_PWM_PERIOD = 0x0A;
  static final int SET_PIN_ANALOG_IN = 0x0B;
  static final int REPORT_ANALOG_IN_STATUS = 0x0B;
  static final int SET_ANALOG_IN_SAMPLING = 0x0C;
  static final int REPORT_ANALOG_IN_FORMAT = 0x0C;
  static final int UART_CONFIG = 0x0D;
  static final int UART_STATUS = 0x0D;
  static final int UART_DATA = 0x0E;
  static final int SET_PIN_UART = 0x0F;
  static final int UART_REPORT_TX_STATUS = 0x0F;
  static final int INCAP_CONFIG = 0x1B;
  static final int INCAP_STATUS = 0x1B;
  static final int SET_PIN_INCAP = 0x1C;
  static final int INCAP_REPORT = 0x1C;
  static final int SOFT_CLOSE = 0x1D;
  static final int SYNC = 0x23;

  /** Maximum message length: type, fixed part, 64 UART bytes. */
  static final int LONGEST = 66;

  private static final int UNKNOWN = -1;
  private static final int[] LENGTHS = new int[SYNC + 1]; // lengths of messages to the board

  static {
    Arrays.fill(LENGTHS, UNKNOWN);
    LENGTHS[HARD_RESET] = 4;
    LENGTHS[SOFT_RESET] = 0;
    LENGTHS[CHECK_INTERFACE] = 8;
    LENGTHS[SET_PIN_DIGITAL_OUT] = 1;
    LENGTHS[SET_DIGITAL_OUT_LEVEL] = 1;
    LENGTHS[SET_PIN_DIGITAL_IN] = 1;
    LENGTHS[SET_CHANGE_NOTIFY] = 1;
    LENGTHS[SET_PIN_PWM] = 2;
    LENGTHS[SET_PWM_DUTY_CYCLE] = 3;
    LENGTHS[SET_PWM_PERIOD] = 3;
    LENGTHS[SET_PIN_ANALOG_IN] = 1;
    LENGTHS[SET_ANALOG_IN_SAMPLING] = 1;
    LENGTHS[UART_CONFIG] = 3;
    LENGTHS[UART_DATA] = 1;
    LENGTHS[SET_PIN_UART] = 2;
    LENGTHS[INCAP_CONFIG] = 2;
    LENGTHS[SET_PIN_INCAP] = 2;
    LENGTHS[SOFT_CLOSE] = 0;
    LENGTHS[SYNC] = 0;
  }

  private Message() {}

  /** Length after the type, without variable data; −1 if the board does not accept the type. */
  static int argumentLength(int type) {
    return type < LENGTHS.length ? LENGTHS[type] : UNKNOWN;
  }
}
