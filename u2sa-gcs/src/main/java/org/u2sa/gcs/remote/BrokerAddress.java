package org.u2sa.gcs.remote;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Address of a broker.
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
   * Parses {@code HOST}, {@code HOST:PORT} or {@code [IPv6]:PORT}; the port defaults to MQTT's.
   *
   * @throws IllegalArgumentException if it has another form
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

  /** Returns the host as written in a URI: IPv6 in brackets. */
  public String hostInAddress() {
    return host.indexOf(':') < 0 ? host : "[" + host + "]";
  }

  @Override
  public String toString() {
    return hostInAddress() + ":" + port;
  }
}
