package org.u2sa.benchmarks.mqtt;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.u2sa.interfaces.mqtt.LocalToken;

/** What plain clients need at our broker, as any program of the account may have it. */
final class Token {
  private Token() {}

  /** The token of the broker at a port; empty if that broker wants none. */
  static Optional<String> of(int port) throws IOException {
    Path file = LocalToken.file("127.0.0.1", port);
    return Files.exists(file) ? Optional.of(Files.readString(file).trim()) : Optional.empty();
  }
}
