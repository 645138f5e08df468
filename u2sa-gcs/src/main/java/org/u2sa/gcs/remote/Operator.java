package org.u2sa.gcs.remote;

import java.net.InetAddress;
import java.net.UnknownHostException;

/** The person at this machine, as orders and recordings name them. */
public final class Operator {
  private Operator() {}

  /** Returns the operator's name for logs: {@code user@host}. */
  public static String name() {
    String user = System.getProperty("user.name", "unknown");
    try {
      return user + "@" + InetAddress.getLocalHost().getHostName();
    } catch (UnknownHostException e) {
      return user + "@localhost"; // own host name unknown
    }
  }
}
