package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;

/**
 * Login token of a local broker, in a file readable only by the account that started it: that
 * account's programs log in as user {@value #USER}, other accounts cannot. Regenerated at each
 * broker start.
 */
public final class LocalToken {
  /** User name for token logins. */
  public static final String USER = "local";

  private static final int MAX_BYTES = 256;
  private static final String USUAL = "127.0.0.1";
  private static final Pattern IPV4 = Pattern.compile("127(\\.[0-9]{1,3}){3}");

  private LocalToken() {}

  /**
   * Name of a broker's token file in each of the {@link AccountFolders}. Each loopback address has
   * its own file, because another account could listen on an address where the broker does not, and
   * would receive the token.
   */
  public static String fileName(String address, int port) {
    String other = loopback(address).orElse(address);
    String suffix = other.equals(USUAL) ? "" : "-" + other.replaceAll("[^0-9A-Za-z.-]", "_");
    return "broker-" + port + suffix + ".token";
  }

  /**
   * Token of a local broker; empty if this account has none, or if others could read or write the
   * file. Of several tokens, the newest belongs to the running broker.
   */
  public static Optional<char[]> read(String host, int port) {
    return read(AccountFolders.ofProcess(), host, port);
  }

  static Optional<char[]> read(AccountFolders folders, String host, int port) {
    if (!loopback(host).isPresent()) {
      return Optional.empty();
    }
    Optional<char[]> newest = Optional.empty();
    long newestMs = Long.MIN_VALUE;
    for (Path folder : folders.readable()) {
      Path file = folder.resolve(fileName(host, port));
      try {
        long writtenMs = Files.getLastModifiedTime(file).toMillis();
        Optional<char[]> token = writtenMs > newestMs ? read(file) : Optional.empty();
        if (token.isPresent()) {
          newest = token;
          newestMs = writtenMs;
        }
      } catch (IOException | BadInputException e) {
        continue; // absent or open to others; the broker decides what is allowed without it
      }
    }
    return newest;
  }

  private static Optional<char[]> read(Path file) throws IOException {
    SecretFiles.requireClosed("local token", file);
    if (Files.size(file) > MAX_BYTES) {
      return Optional.empty();
    }
    String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8).trim();
    return text.isEmpty() ? Optional.empty() : Optional.of(text.toCharArray());
  }

  /**
   * Locations searched without finding a token; empty if one was found, or if the broker is on
   * another host.
   */
  public static List<Path> missing(String host, int port) {
    return missing(AccountFolders.ofProcess(), host, port);
  }

  static List<Path> missing(AccountFolders folders, String host, int port) {
    List<Path> looked = new ArrayList<>();
    if (loopback(host).isPresent() && !read(folders, host, port).isPresent()) {
      for (Path folder : folders.all()) {
        looked.add(folder.resolve(fileName(host, port)));
      }
    }
    return looked;
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
