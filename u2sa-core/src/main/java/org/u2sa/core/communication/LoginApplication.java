package org.u2sa.core.communication;

import java.net.InetAddress;
import java.util.function.Consumer;

/** Somebody's wish to be let in under a name. Compared by identity: each is a wish of its own. */
final class LoginApplication {
  private final String name;
  private final byte[] password;
  private final String from;
  private final Consumer<Authenticator.Verdict> answer;

  LoginApplication(
      String name, byte[] password, InetAddress from, Consumer<Authenticator.Verdict> answer) {
    this.name = name;
    this.password = password;
    this.from = SourceNetwork.of(from);
    this.answer = answer;
  }

  String name() {
    return name;
  }

  byte[] password() {
    return password;
  }

  /** The address, or for IPv6 its network. */
  String from() {
    return from;
  }

  /** Name and address together. */
  String key() {
    return from + " " + name;
  }

  /** Takes the verdict; called once. */
  Consumer<Authenticator.Verdict> answer() {
    return answer;
  }
}
