package org.u2sa.chaos;

import static java.nio.charset.StandardCharsets.UTF_8;

/** The first packet of an MQTT 3.1.1 client (OASIS MQTT 3.1.1, section 3.1). */
final class MqttConnect {
  private static final int CONNECT = 0x10;
  private static final int AFTER_LENGTH_BEFORE_ID = 10; // "MQTT", level, flags, keep alive
  private static final int MORE = 0x80;

  private MqttConnect() {}

  /** The client ID; "?" if the bytes do not begin with a whole CONNECT. */
  static String clientId(byte[] bytes, int size) {
    int at = 1;
    while (at < size && (bytes[at] & MORE) != 0) {
      at++;
    }
    at += 1 + AFTER_LENGTH_BEFORE_ID;
    if (size < at + 2 || bytes[0] != CONNECT) {
      return "?";
    }
    int length = (bytes[at] & 0xff) << 8 | bytes[at + 1] & 0xff;
    return size < at + 2 + length ? "?" : new String(bytes, at + 2, length, UTF_8);
  }
}
