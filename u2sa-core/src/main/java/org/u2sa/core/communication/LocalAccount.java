package org.u2sa.core.communication;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.EnumSet;
import java.util.function.Consumer;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.SecretFile;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.LocalToken;

/**
 * The account under which this program runs, as a user of a broker that only this host can reach:
 * whoever can read the token file has full access, everybody else may listen and query.
 */
final class LocalAccount implements AutoCloseable {
  private final Path file;
  private final ProcessAccount own = ProcessAccount.named(LocalToken.USER);
  private final User anybody =
      ProcessAccount.with(ConnectionFilter.ANONYMOUS, EnumSet.of(AccessRole.OBSERVER)).user();
  private final Consumer<String> log;
  private boolean published; // while the broker is being started

  private LocalAccount(Path file, Consumer<String> log) {
    this.log = log;
    this.file = file;
  }

  /**
   * Makes a new token for the broker that is to listen there, and writes it down unless another
   * broker does, whose token it would overwrite.
   *
   * @param log is told if it cannot be written, and what follows
   */
  static LocalAccount at(String bindAddress, int port, Consumer<String> log) {
    LocalAccount account = new LocalAccount(LocalToken.file(bindAddress, port), log);
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

  /** Writes the token down, unless that is done. Where it fails, nobody else has one. */
  void publish() {
    if (published) {
      return;
    }
    published = true;
    try {
      Path folder = file.toAbsolutePath().getParent();
      Files.createDirectories(folder);
      if (folder.getFileSystem().supportedFileAttributeViews().contains("posix")) {
        Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwx------"));
      }
      SecretFile.write(file, (own.password() + "\n").getBytes(StandardCharsets.UTF_8));
    } catch (IOException | BadInputException e) {
      log.accept(
          "WARNING: no token for the programs of this account, which can only listen: "
              + e.getMessage());
    }
  }

  /** The account's programs. */
  ProcessAccount own() {
    return own;
  }

  /** Anonymous clients. */
  User anybody() {
    return anybody;
  }

  /** Removes the token, unless a later broker of that port has put its own there. */
  @Override
  public void close() {
    try {
      if (Files.isRegularFile(file)
          && new String(Files.readAllBytes(file), StandardCharsets.UTF_8)
              .trim()
              .equals(own.password())) {
        Files.delete(file);
      }
    } catch (IOException e) {
      return; // of use to nobody: the broker that it opens has ended
    }
  }
}
