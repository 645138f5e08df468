package org.u2sa.core.communication;

import io.netty.handler.ssl.SslContext;
import io.netty.handler.ssl.SslContextBuilder;
import io.netty.handler.ssl.SslProvider;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.InvalidPathException;
import java.nio.file.Paths;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.net.ssl.SSLException;
import org.u2sa.core.communication.access.AccountLogin;
import org.u2sa.core.communication.access.LocalAccount;
import org.u2sa.core.communication.access.ProcessAccount;
import org.u2sa.core.communication.access.Users;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.LocalToken;

/** Security of the embedded broker: users and encryption, or listening on this host only. */
final class BrokerSecurity {
  record Variables(
      @Variable(ifAbsentText = "")
          @Description(
              "Folder made by ./u2sa security init; with it the embedded broker accepts only users with passwords, over TLS.")
          String securityDirectory,
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether the embedded broker may listen on a network without SECURITY DIRECTORY, where anyone can command the vehicle.")
          boolean allowInsecureNetwork,
      @Variable(
              oneOf = {"account", "everybody"},
              ifAbsentText = "account")
          @Description(
              "Who on this host may command without SECURITY DIRECTORY: the account that started the broker (tools read its private token file), or everybody. Everybody may listen.")
          String localCommands) {}

  private static final String LOOPBACK = "127.0.0.1";

  private final LocalAccount account; // null without users, or with the directory's users
  private final SecurityDirectory directory; // null without users and encryption
  private final SslContext tls; // null likewise
  private final ProcessAccount own; // null grants everyone full access
  private final AccountLogin login; // of programs of this account; null without users
  private volatile Users users; // of the directory and the present broker

  BrokerSecurity(SecurityDirectory directory, SslContext tls) {
    this(directory, tls, null, directory == null ? null : ProcessAccount.unnamed(), null);
  }

  private BrokerSecurity(
      SecurityDirectory directory,
      SslContext tls,
      LocalAccount account,
      ProcessAccount own,
      AccountLogin login) {
    this.account = account;
    this.directory = directory;
    this.tls = tls;
    this.own = own;
    this.login = login;
  }

  /**
   * Reads the users and the certificate.
   *
   * @param bindAddress address on which the broker will listen
   * @throws BadInputException if that would expose an unsecured broker to a network, or a file is
   *     invalid
   */
  static BrokerSecurity of(Variables settings, String bindAddress, int port, Consumer<String> log) {
    if (!settings.securityDirectory.isEmpty()) {
      return secured(settings.securityDirectory, bindAddress, port, log);
    }
    if (!isLoopback(bindAddress)) {
      if (!settings.allowInsecureNetwork) {
        throw new BadInputException(
            "BIND ADDRESS "
                + bindAddress
                + " opens the Communication Manager to a network, but it has neither users nor encryption: "
                + "create both with ./u2sa security init in the folder security, and set "
                + "SECURITY DIRECTORY to it; "
                + "or set ALLOW INSECURE NETWORK");
      }
      log.accept(
          "WARNING: ALLOW INSECURE NETWORK: everyone who reaches "
              + bindAddress
              + " can listen to and command this vehicle");
    } else if (settings.localCommands.equals("account")) {
      LocalAccount account = LocalAccount.at(bindAddress, port, log);
      return new BrokerSecurity(null, null, account, account.own(), null);
    }
    return new BrokerSecurity(null, null, null, null, null);
  }

  private static BrokerSecurity secured(
      String path, String bindAddress, int port, Consumer<String> log) {
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
      ProcessAccount own = ProcessAccount.unnamed();
      AccountLogin login =
          new AccountLogin(own, directory.authority(), hereAt(bindAddress), port, log);
      return new BrokerSecurity(directory, tls, null, own, login);
    } catch (SSLException | IllegalArgumentException e) {
      throw new BadInputException(
          String.format(
              "SECURITY DIRECTORY \"%s\": server.pem and server-key.pem cannot be used: %s",
              path, e.getMessage()),
          e);
    }
  }

  /** The address by which programs of this host reach a broker. */
  static String hereAt(String bindAddress) {
    try {
      return InetAddress.getByName(bindAddress).isAnyLocalAddress() ? LOOPBACK : bindAddress;
    } catch (UnknownHostException e) {
      return bindAddress; // listening will fail with an error
    }
  }

  static boolean isLoopback(String address) {
    try {
      return InetAddress.getByName(address).isLoopbackAddress();
    } catch (UnknownHostException e) {
      return false; // listening will fail with an error
    }
  }

  /**
   * Prints the address of the operator's page and how to log in. The link with the token is shown
   * on a terminal only, because others may read a program's log.
   */
  String loginLine(String link) {
    if (directory != null) {
      return "Operator's page: " + link + ", for users of the SECURITY DIRECTORY";
    }
    if (account == null) {
      return "Operator's page: " + link + ", where everybody may command";
    }
    return System.console() != null
        ? "Operator's page: " + link + "#" + own.password()
        : "Operator's page: " + link + ", user local, password in " + account.tokenFile();
  }

  boolean isOn() {
    return directory != null;
  }

  /** Whether a user may command, as far as known in memory; an empty name is anonymous. */
  boolean isOperator(String user) {
    return directory == null
        ? own == null || user.equals(LocalToken.USER)
        : users
            .named(user)
            .filter(known -> known.roles().contains(AccessRole.OPERATOR))
            .isPresent();
  }

  /** The users' folder; empty if there are no users with passwords. */
  Optional<SecurityDirectory> directory() {
    return Optional.ofNullable(directory);
  }

  /** Encryption for a broker's connections; null for plain text. */
  Encryption encryption() {
    return tls == null ? null : new Encryption(tls);
  }

  /** Access of a client without a name. */
  BrokerAccess anonymous() {
    return BrokerAccess.of(
        "", "", false, directory == null ? "" : directory.authority().toString());
  }

  /** The known users, read again; null if anyone may connect without a password. */
  Users users(Consumer<String> log) {
    if (account != null) {
      return new Users(account);
    }
    if (directory == null) {
      return null;
    }
    users = new Users(directory.users(), log);
    users.add(own.user());
    return users;
  }

  /** Credentials of the services of the broker's own process. */
  BrokerAccess ownAccess() {
    if (own == null) {
      return BrokerAccess.open();
    }
    return BrokerAccess.of(
        own.user().name(),
        own.password().toCharArray(),
        directory == null ? "" : directory.authority().toString());
  }

  /** Starts the broker secured by this; on failure, undoes both. */
  <B> B starting(Supplier<B> start) {
    try {
      B broker = start.get();
      if (account != null) {
        account.publish();
      }
      if (login != null) {
        login.publish();
      }
      return broker;
    } catch (RuntimeException | Error e) {
      close();
      throw e;
    }
  }

  /** Removes what {@link #of} has created. */
  void close() {
    if (account != null) {
      account.close();
    }
    if (login != null) {
      login.close();
    }
  }
}
