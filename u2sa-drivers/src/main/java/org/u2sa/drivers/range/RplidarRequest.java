package org.u2sa.drivers.range;

/** Requests to an RPLIDAR that carry a payload (LR001, "request packets' format"). */
final class RplidarRequest {
  private static final int START = 0xA5;
  private static final int SET_MOTOR_PWM = 0xF0;

  private RplidarRequest() {}

  /** Start, command, length, payload, and the check sum: all before it, by exclusive or. */
  static byte[] of(int command, int... payload) {
    byte[] request = new byte[payload.length + 4];
    request[0] = (byte) START;
    request[1] = (byte) command;
    request[2] = (byte) payload.length;
    for (int i = 0; i < payload.length; i++) {
      request[3 + i] = (byte) payload[i];
    }
    int sum = 0;
    for (byte each : request) {
      sum ^= each;
    }
    request[request.length - 1] = (byte) sum;
    return request;
  }

  /**
   * Runs the motor.
   *
   * @param width of the pulses, 0…1023; 0 stops it
   */
  static byte[] motor(int width) {
    return of(SET_MOTOR_PWM, width & 0xFF, width >> 8);
  }
}
