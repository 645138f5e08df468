package org.u2sa.drivers.motor;

/** CRC-16 with polynomial 0x1021 from 0, as XMODEM and RoboClaw have it. */
final class Crc16 {
  private static final int POLYNOMIAL = 0x1021;
  private static final int TOP = 0x8000;
  private static final int MASK = 0xFFFF;

  private Crc16() {}

  /** Goes on from what was computed of the bytes before; begin with 0. */
  static int of(int before, byte[] bytes, int from, int to) {
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
