package org.u2sa.core.communication.access;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.function.Consumer;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.mqtt.AccountFile;
import org.u2sa.interfaces.mqtt.AccountFolders;
import org.u2sa.interfaces.mqtt.LocalToken;

/**
 * Access to a broker that only this host can reach: programs that can read the token, i.e. run
 * under the same account, have full access; all others may only listen and query.
 */
public final class LocalAccount implements AutoCloseable {
  /** User name of anonymous clients. */
  public static final String ANONYMOUS = "anonymous";

  private final AccountFolders folders = AccountFolders.ofProcess();
  private final String fileName;
  private final ProcessAccount own = ProcessAccount.named(LocalToken.USER);
  private final User anybody =
      ProcessAccount.with(ANONYMOUS, EnumSet.of(AccessRole.OBSERVER)).user();
  private final Consumer<String> log;
  private AccountFile token; // null until published; used by the thread that starts the broker

  private LocalAccount(String fileName, Consumer<String> log) {
    this.log = log;
    this.fileName = fileName;
  }

  /**
   * Creates a token for the broker at this address and writes it to its files, unless another
   * broker already listens there.
   *
   * @param log receives the consequence if a file cannot be written
   */
  public static LocalAccount at(String bindAddress, int port, Consumer<String> log) {
    LocalAccount account = new LocalAccount(LocalToken.fileName(bindAddress, port), log);
    if (isFree(new InetSocketAddress(bindAddress, port))) {
      account.publish();
    }
    return account;
  }

  private static boolean isFree(InetSocketAddress address) {
    try (ServerSocket probe = new ServerSocket()) {
      probe.bind(address);
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  /** Writes the token to its files, unless already written, and keeps them there. */
  public void publish() {
    if (token == null) {
      token =
          new AccountFile(
              folders,
              fileName,
              own.password() + "\n",
              failure ->
                  log.accept(
                      "WARNING: cannot write a token, so programs of this account can only listen: "
                          + failure));
    }
  }

  /** The token's file; of several copies, the first. */
  public Path tokenFile() {
    List<Path> files = new ArrayList<>();
    folders.all().forEach(folder -> files.add(folder.resolve(fileName)));
    return files.stream().filter(Files::exists).findFirst().orElse(files.get(0));
  }

  /** User for programs with the token. */
  public ProcessAccount own() {
    return own;
  }

  /** User for anonymous clients. */
  User anybody() {
    return anybody;
  }

  /** Removes the token's files, unless a later broker on this port has replaced them. */
  @Override
  public void close() {
    if (token != null) {
      token.close();
    }
  }
}
