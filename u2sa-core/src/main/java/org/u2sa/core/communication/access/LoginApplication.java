package org.u2sa.core.communication.access;

import java.net.InetAddress;
import java.util.function.Consumer;
import org.u2sa.core.communication.limit.SourceNetwork;

/**
 * A login request. Equality is by identity, because the password is an array.
 *
 * @param from client address, or its network for IPv6
 * @param answer receives the verdict; called once
 */
public record LoginApplication(
    String name, byte[] password, String from, Consumer<Authenticator.Verdict> answer) {
  /** A request from an address. */
  public LoginApplication(
      String name, byte[] password, InetAddress from, Consumer<Authenticator.Verdict> answer) {
    this(name, password, SourceNetwork.of(from), answer);
  }

  /** Key of name and address. */
  String key() {
    return from + " " + name;
  }
}
