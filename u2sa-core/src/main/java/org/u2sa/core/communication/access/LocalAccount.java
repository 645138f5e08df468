package org.u2sa.core.communication.access;

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
import org.u2sa.interfaces.mqtt.LocalToken;

/**
 * Access to a broker that only this host can reach: programs that can read the token file, i.e. run
 * under the same account, have full access; all others may only listen and query.
 */
public final class LocalAccount implements AutoCloseable {
  /** User name of anonymous clients. */
  public static final String ANONYMOUS = "anonymous";

  private final Path file;
  private final ProcessAccount own = ProcessAccount.named(LocalToken.USER);
  private final User anybody =
      ProcessAccount.with(ANONYMOUS, EnumSet.of(AccessRole.OBSERVER)).user();
  private final Consumer<String> log;
  private boolean published; // used while the broker starts

  private LocalAccount(Path file, Consumer<String> log) {
    this.log = log;
    this.file = file;
  }

  /**
   * Creates a new token for the broker that is to listen at this address, and writes it to the
   * file, unless another broker listens there, whose token would be overwritten.
   *
   * @param log notified if the file cannot be written, with the consequence
   */
  public static LocalAccount at(String bindAddress, int port, Consumer<String> log) {
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

  /** Writes the token file, unless already written. On failure, no other program has access. */
  public void publish() {
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

  /** User for programs with the token. */
  public ProcessAccount own() {
    return own;
  }

  /** User for anonymous clients. */
  User anybody() {
    return anybody;
  }

  /** Removes the token file, unless a later broker on this port has replaced it. */
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
      return; // harmless: its broker has ended
    }
  }
}
