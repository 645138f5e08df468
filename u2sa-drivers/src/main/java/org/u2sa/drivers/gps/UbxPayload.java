package org.u2sa.drivers.gps;

/** A UBX message as delivered by {@link UbxFramer}. */
final class UbxPayload {
  private final byte[] bytes;
  private int messageClass;
  private int id;
  private int begin;
  private int length;

  UbxPayload(byte[] bytes) {
    this.bytes = bytes;
  }

  void set(int newClass, int newId, int newBegin, int newLength) {
    messageClass = newClass;
    id = newId;
    begin = newBegin;
    length = newLength;
  }

  /** Class and id, such as 0x0107 for NAV-PVT. */
  int kind() {
    return messageClass << 8 | id;
  }

  int length() {
    return length;
  }

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
