package org.u2sa.service;

import java.net.InetAddress;
import java.net.UnknownHostException;

/** The name of the machine, for discovery. */
final class HostName {
  private HostName() {}

  static String get() {
    try {
      return InetAddress.getLocalHost().getHostName();
    } catch (UnknownHostException e) {
      return "localhost"; // the machine has no entry for its own name; it is still this host
    }
  }
}
