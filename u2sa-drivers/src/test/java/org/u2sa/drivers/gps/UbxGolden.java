package org.u2sa.drivers.gps;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.stream.Collectors;

/** Messages of u-blox's protocol as pyubx2 makes them: resources/org/u2sa/drivers/gps/ubx.txt. */
public final class UbxGolden {
  private static final Map<String, byte[]> MESSAGES = read();

  private UbxGolden() {}

  private static Map<String, byte[]> read() {
    try (InputStream in = UbxGolden.class.getResourceAsStream("ubx.txt")) {
      return new String(in.readAllBytes(), StandardCharsets.US_ASCII)
          .lines()
          .map(line -> line.split(" "))
          .collect(Collectors.toMap(parts -> parts[0], parts -> bytes(parts[1])));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static byte[] bytes(String hex) {
    byte[] bytes = new byte[hex.length() / 2];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) Integer.parseInt(hex.substring(2 * i, 2 * i + 2), 16);
    }
    return bytes;
  }

  /** The bytes of messages, one after the other. */
  public static byte[] of(String... names) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (String name : names) {
      all.writeBytes(MESSAGES.get(name));
    }
    return all.toByteArray();
  }

  /**
   * The message with one payload field changed, and its checksum right again.
   *
   * @param offset in the payload
   */
  static byte[] changed(String name, int offset, int... values) {
    byte[] message = of(name);
    for (int i = 0; i < values.length; i++) {
      message[6 + offset + i] = (byte) values[i];
    }
    int first = 0;
    int second = 0;
    for (int i = 2; i < message.length - 2; i++) {
      first = (first + message[i]) & 0xFF;
      second = (second + first) & 0xFF;
    }
    message[message.length - 2] = (byte) first;
    message[message.length - 1] = (byte) second;
    return message;
  }
}
