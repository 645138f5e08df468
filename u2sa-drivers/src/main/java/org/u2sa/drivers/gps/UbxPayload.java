package org.u2sa.drivers.gps;

/**
 * A UBX message as delivered by {@link UbxFramer}.
 *
 * @param kind class and id, such as 0x0107 for NAV-PVT
 * @param begin index of the payload
 * @param length of the payload
 */
record UbxPayload(byte[] bytes, int kind, int begin, int length) {
  int u1(int offset) {
    return bytes[begin + offset] & 0xFF;
  }

  int i4(int offset) {
    return u1(offset) | u1(offset + 1) << 8 | u1(offset + 2) << 16 | u1(offset + 3) << 24;
  }

  long u4(int offset) {
    return i4(offset) & 0xFFFFFFFFL;
  }
}
