package org.u2sa.interfaces.communication;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Optional;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;

/**
 * The password of whoever started the broker of a port of this host, in a file that only that
 * account can read: its other programs come as user {@value #USER} without being told, other
 * accounts do not. Another one for each start of a broker, so that who takes the port later learns
 * nothing of use.
 */
public final class LocalToken {
  /** User name of clients that log in with the token. */
  public static final String USER = "local";

  private static final int MOST_BYTES = 256;
  private static final String USUAL = "127.0.0.1";
  private static final Pattern IPV4 = Pattern.compile("127(\\.[0-9]{1,3}){3}");

  private LocalToken() {}

  /**
   * The file of a broker's token: in {@code $XDG_RUNTIME_DIR/u2sa}, or else in {@code ~/.u2sa/run}.
   * Each loopback address has its own: where the broker does not listen, any account may, and would
   * be told the token.
   *
   * @param address at which the broker listens
   * @param port at which the broker listens
   */
  public static Path file(String address, int port) {
    String runtime = System.getenv("XDG_RUNTIME_DIR");
    Path folder =
        runtime != null && !runtime.isEmpty() && Files.isDirectory(Paths.get(runtime))
            ? Paths.get(runtime, "u2sa")
            : Paths.get(System.getProperty("user.home", ""), ".u2sa", "run");
    String other = loopback(address).orElse(address);
    String suffix = other.equals(USUAL) ? "" : "-" + other.replaceAll("[^0-9A-Za-z.-]", "_");
    return folder.resolve("broker-" + port + suffix + ".token");
  }

  /**
   * The token of the broker at a port of this host; empty if there is none for this account. One
   * that others could read or have put there is not used.
   */
  static Optional<char[]> read(String host, int port) {
    Path file = file(host, port);
    if (loopback(host).isEmpty() || !Files.isRegularFile(file)) {
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

  /** The loopback address that is meant; empty for any other host, and for names of one. */
  private static Optional<String> loopback(String host) {
    if (host.equalsIgnoreCase("localhost")) {
      return Optional.of(USUAL);
    }
    if (host.equals("::1") || host.equals("[::1]")) {
      return Optional.of("::1");
    }
    return IPV4.matcher(host).matches() ? Optional.of(host) : Optional.empty();
  }
}
