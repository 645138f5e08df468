package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Optional;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;

/**
 * Login token of a local broker, in a file readable only by the account that started it: that
 * account's programs log in as user {@value #USER} automatically, other accounts cannot.
 * Regenerated at each broker start, so a later owner of the port learns nothing useful.
 */
public final class LocalToken {
  /** User name for token logins. */
  public static final String USER = "local";

  private static final int MAX_BYTES = 256;
  private static final String USUAL = "127.0.0.1";
  private static final Pattern IPV4 = Pattern.compile("127(\\.[0-9]{1,3}){3}");

  private LocalToken() {}

  /**
   * Token file of a broker: in {@code $XDG_RUNTIME_DIR/u2sa}, or else in {@code ~/.u2sa/run}. Each
   * loopback address has its own file, because on an address where the broker does not listen
   * another account could, and would receive the token.
   *
   * @param address listening address of the broker
   * @param port listening port of the broker
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
   * Token of a local broker; empty if this account has none. A file that others could read or write
   * is not used.
   */
  static Optional<char[]> read(String host, int port) {
    Path file = file(host, port);
    if (loopback(host).isEmpty() || !Files.isRegularFile(file)) {
      return Optional.empty();
    }
    try {
      SecretFiles.requireClosed("local token", file);
      if (Files.size(file) > MAX_BYTES) {
        return Optional.empty();
      }
      String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8).trim();
      return text.isEmpty() ? Optional.empty() : Optional.of(text.toCharArray());
    } catch (IOException | BadInputException e) {
      return Optional.empty(); // the broker decides what is allowed without it
    }
  }

  /** Normalised loopback address; empty for other hosts and for host names. */
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
