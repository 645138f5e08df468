package org.u2sa.benchmarks.mqtt;

import java.util.Optional;
import org.u2sa.interfaces.mqtt.LocalToken;

/** What plain clients need at our broker, as any program of the account may have it. */
final class Token {
  private Token() {}

  /** The token of the broker at a port; empty if that broker wants none. */
  static Optional<String> of(int port) {
    return LocalToken.read("127.0.0.1", port).map(String::new);
  }
}
