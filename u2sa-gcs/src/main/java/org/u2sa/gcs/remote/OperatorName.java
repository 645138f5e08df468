package org.u2sa.gcs.remote;

import java.net.InetAddress;
import java.net.UnknownHostException;

/** Who sits at this machine: the user's name and the host's. */
final class OperatorName {
  private OperatorName() {}

  static String get() {
    String user = System.getProperty("user.name", "unknown");
    try {
      return user + "@" + InetAddress.getLocalHost().getHostName();
    } catch (UnknownHostException e) {
      return user
          + "@localhost"; // the machine has no entry for its own name; it is still this host
    }
  }
}
