package org.u2sa.core.communication.access;

import java.net.InetAddress;
import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.core.communication.limit.SourceNetwork;
import org.u2sa.core.security.User;

/**
 * A login request. Equality is by identity, because the password is an array.
 *
 * @param from client address, or its network for IPv6
 * @param answer receives the verdict; called once
 */
public record LoginApplication(
    String name, byte[] password, String from, Consumer<Verdict> answer) {
  /**
   * The result: a user, or the reason for the refusal.
   *
   * @param isFinal whether retrying with the same password is pointless
   */
  public record Verdict(Optional<User> user, String reason, boolean isFinal) {
    static Verdict wrong(String reason) {
      return new Verdict(Optional.empty(), reason, true);
    }

    /** No decision: the client may try again later. */
    public static Verdict later(String reason) {
      return new Verdict(Optional.empty(), reason, false);
    }

    static Verdict of(User user) {
      return new Verdict(Optional.of(user), "", true);
    }
  }

  /** A request from an address. */
  public LoginApplication(
      String name, byte[] password, InetAddress from, Consumer<Verdict> answer) {
    this(name, password, SourceNetwork.of(from), answer);
  }

  String key() {
    return from + " " + name;
  }
}
