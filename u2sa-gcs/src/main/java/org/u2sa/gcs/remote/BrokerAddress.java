package org.u2sa.gcs.remote;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Where a broker listens.
 *
 * @param host name or address, an IPv6 address without brackets
 * @param port TCP port, 1…65535
 */
public record BrokerAddress(String host, int port) {
  private static final int DEFAULT_PORT = 1883;
  private static final int HIGHEST_PORT = 65_535;
  private static final Pattern FORM =
      Pattern.compile("(?:\\[([0-9A-Fa-f:.%]+)]|([^\\s:\\[\\]/]+))(?::(\\d{1,5}))?");

  /**
   * Reads {@code HOST}, {@code HOST:PORT} or {@code [IPv6]:PORT}; without a port, MQTT's own holds.
   *
   * @throws IllegalArgumentException if it is none of them
   */
  public static BrokerAddress parse(String text) {
    Matcher matcher = FORM.matcher(text);
    if (!matcher.matches()) {
      throw new IllegalArgumentException(
          "\"" + text + "\": expected HOST or HOST:PORT, such as localhost:1883");
    }
    int port = matcher.group(3) == null ? DEFAULT_PORT : Integer.parseInt(matcher.group(3));
    if (port < 1 || port > HIGHEST_PORT) {
      throw new IllegalArgumentException(
          "\"" + text + "\": port " + port + " is outside 1…" + HIGHEST_PORT);
    }
    return new BrokerAddress(matcher.group(1) == null ? matcher.group(2) : matcher.group(1), port);
  }

  /** The host as it stands in an address: IPv6 in brackets. */
  public String hostInAddress() {
    return host.indexOf(':') < 0 ? host : "[" + host + "]";
  }

  @Override
  public String toString() {
    return hostInAddress() + ":" + port;
  }
}
