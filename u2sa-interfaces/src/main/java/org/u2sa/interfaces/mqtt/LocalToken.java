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
 * broker start. A secured broker has a {@link Login} instead.
 */
public final class LocalToken {
  /** User name for token logins. */
  public static final String USER = "local";

  /**
   * Log-in at a secured local broker.
   *
   * @param caFile certificate of the authority that certified the broker; absolute
   */
  record Login(String user, char[] password, String caFile) {}

  private static final int MAX_BYTES = 256;
  private static final int MAX_LOGIN_BYTES = 8_192; // a path has at most 4096
  private static final String USUAL = "127.0.0.1";
  private static final Pattern IPV4 = Pattern.compile("127(\\.[0-9]{1,3}){3}");

  private LocalToken() {}

  /**
   * Name of a broker's token file in each of the {@link AccountFolders}. Each loopback address has
   * its own file, because another account could listen on an address where the broker does not, and
   * would receive the token.
   */
  public static String fileName(String address, int port) {
    return fileName(address, port, ".token");
  }

  /** Name of the file with a secured broker's log-in, as {@link #fileName}. */
  public static String loginFileName(String address, int port) {
    return fileName(address, port, ".login");
  }

  /** Content of that file. */
  public static String loginText(String user, String password, Path caFile) {
    return user + '\n' + password + '\n' + caFile.toAbsolutePath() + '\n';
  }

  private static String fileName(String address, int port, String extension) {
    String other = loopback(address).orElse(address);
    String suffix = other.equals(USUAL) ? "" : "-" + other.replaceAll("[^0-9A-Za-z.-]", "_");
    return "broker-" + port + suffix + extension;
  }

  /**
   * Token of a local broker; empty if this account has none, or if others could read or write the
   * file. Of several tokens, the newest belongs to the running broker.
   */
  public static Optional<char[]> read(String host, int port) {
    return read(AccountFolders.ofProcess(), host, port);
  }

  static Optional<char[]> read(AccountFolders folders, String host, int port) {
    return newest(folders, host, fileName(host, port), MAX_BYTES)
        .map(token -> token.text.toCharArray());
  }

  /** Log-in at a secured local broker; empty if {@link #read} has the token of a later broker. */
  static Optional<Login> login(AccountFolders folders, String host, int port) {
    Optional<Written> login = newest(folders, host, loginFileName(host, port), MAX_LOGIN_BYTES);
    long tokenMs =
        newest(folders, host, fileName(host, port), MAX_BYTES)
            .map(token -> token.atMs)
            .orElse(Long.MIN_VALUE);
    return login
        .filter(found -> found.atMs >= tokenMs)
        .map(found -> found.text.split("\n"))
        .filter(lines -> lines.length == 3)
        .map(lines -> new Login(lines[0], lines[1].toCharArray(), lines[2]));
  }

  private record Written(String text, long atMs) {}

  private static Optional<Written> newest(
      AccountFolders folders, String host, String name, int maxBytes) {
    Optional<Written> newest = Optional.empty();
    if (!loopback(host).isPresent()) {
      return newest;
    }
    for (Path folder : folders.readable()) {
      try {
        Optional<Written> found = written(folder.resolve(name), maxBytes);
        if (found.isPresent() && (!newest.isPresent() || found.get().atMs > newest.get().atMs)) {
          newest = found;
        }
      } catch (IOException | BadInputException e) {
        continue; // absent or open to others; the broker decides what is allowed without it
      }
    }
    return newest;
  }

  private static Optional<Written> written(Path file, int maxBytes) throws IOException {
    long atMs = Files.getLastModifiedTime(file).toMillis();
    SecretFiles.requireClosed("local token", file);
    if (Files.size(file) > maxBytes) {
      return Optional.empty();
    }
    String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8).trim();
    return text.isEmpty() ? Optional.empty() : Optional.of(new Written(text, atMs));
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
