package org.u2sa.drivers.motor;

import java.nio.ByteBuffer;

/**
 * A command of RoboClaw's packet serial protocol and its reply (RoboClaw Series User Manual,
 * "Packet Serial" and "Advanced Packet Serial").
 *
 * @param command number of the command
 * @param data payload, big-endian
 * @param answerBytes length of reply data without CRC; 0 for commands that are only acknowledged
 */
record RoboClawRequest(int command, byte[] data, int answerBytes) {
  private static final int SET_SERIAL_TIMEOUT = 14;
  private static final int READ_MAIN_BATTERY = 24;
  private static final int DRIVE_SIGNED_DUTY = 34;
  private static final int DRIVE_SIGNED_SPEED = 37;
  private static final int READ_ENCODER_COUNTERS = 78;

  private static final double TIMEOUT_STEP_S = 0.1;
  private static final double FULL_DUTY = 32_767.0;
  private static final double FULL_PERCENT = 100.0;
  private static final int CRC_BYTES = 2;
  private static final int POLYNOMIAL = 0x1021;
  private static final int TOP = 0x8000;
  private static final int MASK = 0xFFFF;
  private static final byte ACKNOWLEDGED = (byte) 0xFF;

  /** Sets the serial time-out, after which the controller stops both motors [s]. */
  static RoboClawRequest serialTimeout(double seconds) {
    return new RoboClawRequest(
        SET_SERIAL_TIMEOUT, new byte[] {(byte) Math.ceil(seconds / TIMEOUT_STEP_S - 1.0e-9)}, 0);
  }

  /** Signed duty cycles of both motors, −100…100 %. */
  static RoboClawRequest duty(double firstPercent, double secondPercent) {
    int first = (int) Math.round(firstPercent / FULL_PERCENT * FULL_DUTY);
    int second = (int) Math.round(secondPercent / FULL_PERCENT * FULL_DUTY);
    byte[] data = {(byte) (first >> 8), (byte) first, (byte) (second >> 8), (byte) second};
    return new RoboClawRequest(DRIVE_SIGNED_DUTY, data, 0);
  }

  /** Signed closed-loop speeds of both motors [encoder counts/s]. */
  static RoboClawRequest speed(double firstPerS, double secondPerS) {
    ByteBuffer data = ByteBuffer.allocate(8); // big-endian
    data.putInt((int) Math.round(firstPerS)).putInt((int) Math.round(secondPerS));
    return new RoboClawRequest(DRIVE_SIGNED_SPEED, data.array(), 0);
  }

  /** The counters of both encoders, 4 bytes each. */
  static RoboClawRequest encoders() {
    return new RoboClawRequest(READ_ENCODER_COUNTERS, new byte[0], 8);
  }

  /** The motors' battery, 2 bytes, tenths of volts. */
  static RoboClawRequest battery() {
    return new RoboClawRequest(READ_MAIN_BATTERY, new byte[0], 2);
  }

  boolean isEncoders() {
    return command == READ_ENCODER_COUNTERS;
  }

  boolean isBattery() {
    return command == READ_MAIN_BATTERY;
  }

  boolean isSerialTimeout() {
    return command == SET_SERIAL_TIMEOUT;
  }

  /** Encoded request: address, command, data, and a CRC unless it is a read. */
  byte[] packet(int address) {
    byte[] packet = new byte[2 + data.length + (answerBytes == 0 ? CRC_BYTES : 0)];
    packet[0] = (byte) address;
    packet[1] = (byte) command;
    System.arraycopy(data, 0, packet, 2, data.length);
    if (answerBytes == 0) {
      int end = packet.length - CRC_BYTES;
      int crc = crc(0, packet, 0, end);
      packet[end] = (byte) (crc >> 8);
      packet[end + 1] = (byte) crc;
    }
    return packet;
  }

  int replyLength() {
    return answerBytes == 0 ? 1 : answerBytes + CRC_BYTES;
  }

  /** Whether a reply is valid: the CRC covers address, command and data. */
  boolean isAnsweredBy(int address, byte[] reply, int length) {
    if (length != replyLength()) {
      return false;
    }
    if (answerBytes == 0) {
      return reply[0] == ACKNOWLEDGED;
    }
    int crc = crc(0, new byte[] {(byte) address, (byte) command}, 0, 2);
    crc = crc(crc, reply, 0, answerBytes);
    return crc == unsigned16(reply, answerBytes);
  }

  /** A 16-bit number in a reply. */
  static int unsigned16(byte[] reply, int at) {
    return (reply[at] & 0xFF) << 8 | reply[at + 1] & 0xFF;
  }

  /** A 32-bit number in a reply. */
  static int signed32(byte[] reply, int at) {
    return unsigned16(reply, at) << 16 | unsigned16(reply, at + 2);
  }

  /**
   * CRC-16/XMODEM, polynomial 0x1021.
   *
   * @param before CRC of the preceding bytes; 0 at the start
   */
  static int crc(int before, byte[] bytes, int from, int to) {
    int crc = before;
    for (int i = from; i < to; i++) {
      crc ^= (bytes[i] & 0xFF) << 8;
      for (int bit = 0; bit < 8; bit++) {
        crc = (crc & TOP) == 0 ? crc << 1 : crc << 1 ^ POLYNOMIAL;
      }
      crc &= MASK;
    }
    return crc;
  }
}
