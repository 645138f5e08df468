package org.u2sa.drivers.gps;

import java.io.ByteArrayOutputStream;

/** Writes a message of u-blox's binary protocol, low bytes first. */
final class UbxWriter {
  private final int kind;
  private final ByteArrayOutputStream payload = new ByteArrayOutputStream();

  UbxWriter(int kind) {
    this.kind = kind;
  }

  UbxWriter u1(int value) {
    payload.write(value);
    return this;
  }

  UbxWriter u2(int value) {
    return u1(value).u1(value >> 8);
  }

  UbxWriter u4(int value) {
    return u2(value).u2(value >> 16);
  }

  byte[] frame() {
    return UbxFramer.frame(kind >> 8, kind & 0xFF, payload.toByteArray());
  }
}
