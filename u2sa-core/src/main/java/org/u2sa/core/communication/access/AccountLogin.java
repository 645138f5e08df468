package org.u2sa.core.communication.access;

import java.nio.file.Path;
import java.util.function.Consumer;
import org.u2sa.interfaces.mqtt.AccountFile;
import org.u2sa.interfaces.mqtt.AccountFolders;
import org.u2sa.interfaces.mqtt.LocalToken;

/**
 * Log-in at a secured broker for the programs of the account that started it, which can read its
 * keys anyway: in a file that only this account can read, with the authority to trust.
 */
public final class AccountLogin implements AutoCloseable {
  private final String fileName;
  private final String content;
  private final Consumer<String> log;
  private AccountFile file; // null until published; used by the thread that starts the broker

  /**
   * @param address loopback address by which this host reaches the broker
   * @param authority certificate that programs trust
   * @param log receives the consequence if the file cannot be written
   */
  public AccountLogin(
      ProcessAccount own, Path authority, String address, int port, Consumer<String> log) {
    fileName = LocalToken.loginFileName(address, port);
    content = LocalToken.loginText(own.user().name(), own.password(), authority);
    this.log = log;
  }

  /** Writes it, and keeps it there until {@link #close}. */
  public void publish() {
    file =
        new AccountFile(
            AccountFolders.ofProcess(),
            fileName,
            content,
            failure ->
                log.accept(
                    "WARNING: cannot write a log-in, so programs of this account need --user: "
                        + failure));
  }

  @Override
  public void close() {
    if (file != null) {
      file.close();
    }
  }
}
