package org.u2sa.drivers.nmea;

import static java.nio.charset.StandardCharsets.US_ASCII;

/** Makes sentences for tests. */
public final class Nmea {
  private Nmea() {}

  /** The sentence with its checksum and line end: {@code line("GPRMC,…")}. */
  public static String line(String body) {
    int sum = 0;
    for (byte each : body.getBytes(US_ASCII)) {
      sum ^= each;
    }
    return String.format("$%s*%02X\r\n", body, sum);
  }

  /** {@link #line} as bytes. */
  public static byte[] bytes(String... bodies) {
    StringBuilder all = new StringBuilder();
    for (String body : bodies) {
      all.append(line(body));
    }
    return all.toString().getBytes(US_ASCII);
  }
}
