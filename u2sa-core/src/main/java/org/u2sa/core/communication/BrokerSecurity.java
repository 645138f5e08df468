package org.u2sa.core.communication;

import io.netty.handler.ssl.SslContext;
import io.netty.handler.ssl.SslContextBuilder;
import io.netty.handler.ssl.SslProvider;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.InvalidPathException;
import java.nio.file.Paths;
import java.util.function.Consumer;
import javax.net.ssl.SSLException;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.Configurator;
import org.u2sa.interfaces.Variable;

/**
 * How the embedded broker is secured: by users and encryption, or by being heard on this host only.
 */
final class BrokerSecurity {
  static final Variable<String> DIRECTORY =
      Variable.text("SECURITY DIRECTORY")
          .ifAbsent("")
          .describedAs(
              "Folder made by ./u2sa security init; with it the embedded broker takes users with passwords over TLS only.");

  static final Variable<Boolean> ALLOW_INSECURE_NETWORK =
      Variable.flag("ALLOW INSECURE NETWORK")
          .ifAbsent(false)
          .describedAs(
              "Whether the embedded broker may listen to a network without SECURITY DIRECTORY: everyone there commands the vehicle.");

  private final SecurityDirectory directory; // null: neither users nor encryption
  private final SslContext tls; // null likewise

  BrokerSecurity(SecurityDirectory directory, SslContext tls) {
    this.directory = directory;
    this.tls = tls;
  }

  /** What the configuration says. */
  record Settings(String directory, boolean insecureAllowed) {}

  static Settings settings(Configurator configuration) {
    return new Settings(
        configuration.getVariable(DIRECTORY), configuration.getVariable(ALLOW_INSECURE_NETWORK));
  }

  /**
   * Reads users and certificate.
   *
   * @param bindAddress where the broker is to listen
   * @throws BadInputException if that would open it to a network unsecured, or a file is wrong
   */
  static BrokerSecurity of(Settings settings, String bindAddress, Consumer<String> log) {
    if (!settings.directory.isEmpty()) {
      return secured(settings.directory);
    }
    if (!isLoopback(bindAddress)) {
      if (!settings.insecureAllowed) {
        throw new BadInputException(
            "BIND ADDRESS "
                + bindAddress
                + " opens the Communication Manager to a network, but it has neither users nor encryption: "
                + "make them with ./u2sa security init and name the folder in SECURITY DIRECTORY, "
                + "or say ALLOW INSECURE NETWORK");
      }
      log.accept(
          "WARNING: ALLOW INSECURE NETWORK: everyone who reaches "
              + bindAddress
              + " hears and commands this vehicle");
    }
    return new BrokerSecurity(null, null);
  }

  private static BrokerSecurity secured(String path) {
    SecurityDirectory directory;
    try {
      directory = new SecurityDirectory(Paths.get(path));
    } catch (InvalidPathException e) {
      throw new BadInputException("SECURITY DIRECTORY \"" + path + "\": " + e.getMessage(), e);
    }
    directory.check();
    try {
      SslContext tls =
          SslContextBuilder.forServer(directory.certificate().toFile(), directory.key().toFile())
              .sslProvider(SslProvider.JDK)
              .protocols("TLSv1.3", "TLSv1.2")
              .build();
      return new BrokerSecurity(directory, tls);
    } catch (SSLException | IllegalArgumentException e) {
      throw new BadInputException(
          "SECURITY DIRECTORY \""
              + path
              + "\": server.pem and server-key.pem cannot be used: "
              + e.getMessage(),
          e);
    }
  }

  static boolean isLoopback(String address) {
    try {
      return InetAddress.getByName(address).isLoopbackAddress();
    } catch (UnknownHostException e) {
      return false; // listening there will fail and say so
    }
  }

  boolean isOn() {
    return directory != null;
  }

  SslContext tls() {
    return tls;
  }

  /** Who may come; null: everybody, without a password. */
  Users users(Consumer<String> log) {
    return directory == null ? null : new Users(directory.users(), log);
  }
}
