package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.Certificate;
import java.security.cert.CertificateFactory;
import java.util.Collection;
import java.util.Optional;
import javax.net.SocketFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManagerFactory;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Credentials of a client of the Communication Manager. Immutable; files are read once. */
public final class BrokerAccess {
  /** Login variables for a Communication Manager in another process. */
  public record Login(
      @Variable(ifAbsentText = "")
          @Description(
              "User name at the Communication Manager, if it runs in another process; empty: none.")
          String user,
      @Variable(ifAbsentText = "") @Description("File whose first line is USER's password.")
          String passwordFile,
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether the connection to a Communication Manager in another process is encrypted.")
          boolean tls,
      @Variable(name = "CA FILE", ifAbsentText = "")
          @Description(
              "Trusted CA certificates (PEM); setting them enables TLS. Empty: Java's defaults.")
          String authority) {}

  private static final BrokerAccess OPEN = new BrokerAccess("", new char[0], null, true);
  private static final int LONGEST_CA_FILE = 1 << 20; // bytes: some hundred certificates

  private final String user;
  private final char[] password;
  private final SSLContext tls; // null if unencrypted
  private final boolean usesToken;

  private BrokerAccess(String user, char[] password, SSLContext tls, boolean usesToken) {
    this.user = user;
    this.password = password;
    this.tls = tls;
    this.usesToken = usesToken;
  }

  /** Anonymous and unencrypted; with the account's token at a broker of this host. */
  public static BrokerAccess open() {
    return OPEN;
  }

  /**
   * Access from the variables of {@link Login}.
   *
   * @throws BadInputException if a file is missing or invalid, or the settings contradict each
   *     other
   */
  public static BrokerAccess configured(Configurator configuration) {
    Login login = configuration.settings(Login.class).get();
    return of(login.user(), login.passwordFile(), login.tls(), login.authority());
  }

  /**
   * Creates access from settings; empty texts mean none.
   *
   * @param user name of the user
   * @param passwordFile first line: the password
   * @param encrypted whether to use TLS; a CA file switches it on
   * @param caFile certificates (PEM) of the trusted authorities
   * @throws BadInputException if a file is missing or invalid, or the settings contradict each
   *     other
   */
  public static BrokerAccess of(
      String user, String passwordFile, boolean encrypted, String caFile) {
    if (user.isEmpty() != passwordFile.isEmpty()) {
      throw new BadInputException(
          String.format(
              "USER \"%s\" and PASSWORD FILE \"%s\": expected both or neither",
              user, passwordFile));
    }
    boolean tls = encrypted || !caFile.isEmpty();
    if (user.isEmpty() && !tls) {
      return OPEN;
    }
    char[] password = passwordFile.isEmpty() ? new char[0] : firstLine(passwordFile);
    return new BrokerAccess(user, password, tls ? context(caFile) : null, false);
  }

  /**
   * Access with a password given directly.
   *
   * @param user not empty
   * @param caFile certificates (PEM) of the trusted authorities; empty: no encryption
   */
  public static BrokerAccess of(String user, char[] password, String caFile) {
    return new BrokerAccess(
        user, password.clone(), caFile.isEmpty() ? null : context(caFile), false);
  }

  /**
   * The same encryption for another user, without reading its files again. An empty name is that of
   * a client that gave none: not even the account's token is used.
   */
  BrokerAccess as(String other, char[] secret) {
    return new BrokerAccess(other, secret.clone(), tls, false);
  }

  /**
   * This access; without a user, the log-in of this account is used at a secured broker of this
   * host.
   */
  public BrokerAccess orAccount() {
    return user.isEmpty() ? new BrokerAccess(user, password, tls, true) : this;
  }

  /**
   * This access with the log-in of this account at a secured broker of this host, if it has one.
   */
  BrokerAccess at(String host, int port) {
    return usesToken ? at(AccountFolders.ofProcess(), host, port) : this;
  }

  BrokerAccess at(AccountFolders folders, String host, int port) {
    Optional<LocalToken.Login> login = LocalToken.login(folders, host, port);
    if (!login.isPresent()) {
      return this;
    }
    try {
      SSLContext trusting = tls == null ? context(login.get().caFile()) : tls;
      return new BrokerAccess(login.get().user(), login.get().password(), trusting, false);
    } catch (BadInputException e) { // the authority's file is gone or damaged
      return this; // as another account, which is told what it needs
    }
  }

  private static char[] firstLine(String file) {
    Path path = path("PASSWORD FILE", file);
    SecretFiles.requireClosed("PASSWORD FILE", path);
    try (InputStream in = Files.newInputStream(path)) {
      byte[] bytes = new byte[1024]; // longer than any password
      int length = in.read(bytes);
      String[] lines =
          new String(bytes, 0, Math.max(0, length), StandardCharsets.UTF_8).split("\\R", 2);
      if (lines[0].isEmpty()) {
        throw new BadInputException(
            "PASSWORD FILE \"" + file + "\": its first line is empty; expected the password");
      }
      return lines[0].toCharArray();
    } catch (IOException e) {
      throw new BadInputException("PASSWORD FILE \"" + file + "\" cannot be read: " + e, e);
    }
  }

  private static SSLContext context(String caFile) {
    try {
      SSLContext context = SSLContext.getInstance("TLS");
      if (caFile.isEmpty()) {
        context.init(null, null, null);
        return context;
      }
      KeyStore trusted = KeyStore.getInstance(KeyStore.getDefaultType());
      trusted.load(null, null);
      int count = 0;
      for (Certificate certificate : certificates(caFile)) {
        trusted.setCertificateEntry("authority" + count++, certificate);
      }
      TrustManagerFactory managers =
          TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
      managers.init(trusted);
      context.init(null, managers.getTrustManagers(), null);
      return context;
    } catch (GeneralSecurityException | IOException e) {
      throw new BadInputException("CA FILE \"" + caFile + "\" cannot be used: " + e, e);
    }
  }

  private static Collection<? extends Certificate> certificates(String caFile)
      throws GeneralSecurityException, IOException {
    Path path = path("CA FILE", caFile);
    SecretFiles.requireOwnersWord("CA FILE", path);
    if (Files.exists(path) && !Files.isRegularFile(path)) { // reading a pipe might block forever
      throw new BadInputException("CA FILE \"" + caFile + "\" is not a regular file");
    }
    if (Files.exists(path) && Files.size(path) > LONGEST_CA_FILE) {
      throw new BadInputException(
          "CA FILE \"" + caFile + "\" is longer than 1 MiB; expected certificates in PEM");
    }
    try (InputStream in = Files.newInputStream(path)) {
      Collection<? extends Certificate> found =
          CertificateFactory.getInstance("X.509").generateCertificates(in);
      if (found.isEmpty()) {
        throw new BadInputException(
            "CA FILE \"" + caFile + "\" holds no certificate; expected one or more in PEM");
      }
      return found;
    }
  }

  private static Path path(String variable, String file) {
    try {
      return Paths.get(file);
    } catch (InvalidPathException e) {
      throw new BadInputException(
          variable + " \"" + file + "\" is not a path: " + e.getMessage(), e);
    }
  }

  public Optional<String> user() {
    return user.isEmpty() ? Optional.empty() : Optional.of(user);
  }

  public boolean isEncrypted() {
    return tls != null;
  }

  /** Whether the account's token identifies the user at a broker of this host. */
  boolean usesToken() {
    return usesToken && tls == null;
  }

  char[] password() {
    return password.clone();
  }

  /** URI scheme of the broker address, as used by Paho. */
  String scheme() {
    return tls == null ? "tcp" : "ssl";
  }

  SocketFactory sockets() {
    return tls == null ? new PromptSockets() : new PromptTlsSockets(tls);
  }
}
