package org.u2sa.core.communication;

import java.net.InetAddress;
import java.util.function.Consumer;

/**
 * A request to log in under a name. Equal only to itself: passwords are compared by identity.
 *
 * @param from the address, or for IPv6 its network
 * @param answer takes the verdict; called once
 */
record LoginApplication(
    String name, byte[] password, String from, Consumer<Authenticator.Verdict> answer) {
  LoginApplication(
      String name, byte[] password, InetAddress from, Consumer<Authenticator.Verdict> answer) {
    this(name, password, SourceNetwork.of(from), answer);
  }

  /** Name and address together. */
  String key() {
    return from + " " + name;
  }
}
