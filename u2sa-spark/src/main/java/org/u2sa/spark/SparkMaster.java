package org.u2sa.spark;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;

/**
 * Address of the Spark master that schedules runs.
 *
 * @param text master URL in Spark's syntax
 * @param hosts the cluster's masters, one of which is the leader; empty for local cores
 */
record SparkMaster(String text, List<InetSocketAddress> hosts) {
  private static final Pattern LOCAL = Pattern.compile("local(\\[(\\*|[1-9]\\d{0,3})])?");
  private static final Pattern HOST = Pattern.compile("(\\[[0-9A-Fa-f:.]+]|[^:/\\s]+):(\\d{1,5})");
  private static final String STANDALONE = "spark://";
  private static final String LOOPBACK = "127.0.0.1";
  private static final int ANSWERS_WITHIN_MS = 5000;
  private static final int LAST_PORT = 65535;

  /**
   * Reads {@code local}, {@code local[4]}, {@code local[*]}, {@code spark://HOST:PORT} or, for
   * standby masters, {@code spark://HOST:PORT,HOST:PORT}.
   *
   * @throws BadInputException if the text has another form
   */
  static SparkMaster of(String text) {
    if (LOCAL.matcher(text).matches()) {
      return new SparkMaster(text, List.of());
    }
    if (!text.startsWith(STANDALONE)) {
      throw refused(text, "is not a Spark address");
    }
    List<InetSocketAddress> hosts = new ArrayList<>();
    for (String part : text.substring(STANDALONE.length()).split(",", -1)) {
      Matcher host = HOST.matcher(part);
      int port = host.matches() ? Integer.parseInt(host.group(2)) : 0;
      if (port < 1 || port > LAST_PORT) {
        throw refused(text, "\"" + part + "\" is not a HOST:PORT");
      }
      hosts.add(InetSocketAddress.createUnresolved(host.group(1), port));
    }
    return new SparkMaster(text, hosts);
  }

  private static BadInputException refused(String text, String why) {
    return new BadInputException(
        "--master \""
            + text
            + "\": "
            + why
            + "; expected local[N], local[*] or spark://HOST:PORT (docs/campaigns.md)");
  }

  /** Whether runs are executed outside the driver's process. */
  boolean isCluster() {
    return !hosts.isEmpty();
  }

  /**
   * The address at which the cluster reaches this machine: the local address of a connection to a
   * master.
   *
   * @throws BadInputException if no master answers
   */
  String localAddress() {
    if (!isCluster()) {
      return LOOPBACK;
    }
    List<String> reasons = new ArrayList<>();
    for (InetSocketAddress host : hosts) {
      try (Socket socket = new Socket()) {
        InetSocketAddress resolved = new InetSocketAddress(host.getHostString(), host.getPort());
        socket.connect(resolved, ANSWERS_WITHIN_MS);
        return socket.getLocalAddress().getHostAddress();
      } catch (IOException e) {
        reasons.add(host.getHostString() + ":" + host.getPort() + " (" + e.getMessage() + ")");
      }
    }
    throw new BadInputException(
        "--master \""
            + text
            + "\": no master answers at "
            + String.join(", ", reasons)
            + "; expected a running one: scripts/spark/node master, or Spark's sbin/start-master.sh");
  }
}
