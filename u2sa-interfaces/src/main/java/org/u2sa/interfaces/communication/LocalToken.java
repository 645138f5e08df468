package org.u2sa.interfaces.communication;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;

/**
 * The password of whoever started the broker of a port of this host, in a file that only that
 * account can read: its other programs come as user {@value #USER} without being told, other
 * accounts do not. Another one for each start of a broker, so that who takes the port later learns
 * nothing of use.
 */
public final class LocalToken {
  /** As whom one comes with it. */
  public static final String USER = "local";

  private static final int MOST_BYTES = 256;

  private LocalToken() {}

  /**
   * The file of a broker's token: in {@code $XDG_RUNTIME_DIR/u2sa}, or else in {@code ~/.u2sa/run}.
   *
   * @param port at which the broker listens
   */
  public static Path file(int port) {
    String runtime = System.getenv("XDG_RUNTIME_DIR");
    Path folder =
        runtime != null && !runtime.isEmpty() && Files.isDirectory(Paths.get(runtime))
            ? Paths.get(runtime, "u2sa")
            : Paths.get(System.getProperty("user.home", ""), ".u2sa", "run");
    return folder.resolve("broker-" + port + ".token");
  }

  /**
   * The token of the broker at a port of this host; empty if there is none for this account. One
   * that others could read or have put there is not used.
   */
  static Optional<char[]> read(String host, int port) {
    Path file = file(port);
    if (!isLoopback(host) || !Files.isRegularFile(file)) {
      return Optional.empty();
    }
    try {
      SecretFiles.requireClosed("local token", file);
      if (Files.size(file) > MOST_BYTES) {
        return Optional.empty();
      }
      String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8).trim();
      return text.isEmpty() ? Optional.empty() : Optional.of(text.toCharArray());
    } catch (IOException | BadInputException e) {
      return Optional.empty(); // the broker says what one without it may not do
    }
  }

  private static boolean isLoopback(String host) {
    return host.equalsIgnoreCase("localhost")
        || host.startsWith("127.")
        || host.equals("::1")
        || host.equals("[::1]");
  }
}
