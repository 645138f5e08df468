package org.u2sa.core.communication.access;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.u2sa.core.security.User;
import org.u2sa.core.security.UserFile;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.disk.DiskThread;

/**
 * Users of a running broker: those of the file, which is reloaded when it changes, and temporary
 * users of this run. Thread-safe.
 */
public final class Users {
  private static final DiskThread DISK = new DiskThread("u2sa-users");

  private final AtomicBoolean isLooking = new AtomicBoolean();
  private final Path file; // null if none
  private final Consumer<String> log;
  private final LocalAccount account; // null if users have passwords
  private final Map<String, User> ofThisRun = new ConcurrentHashMap<>();
  private volatile Map<String, User> ofFile;
  private FileTime readAt; // guarded by this

  /**
   * @throws BadInputException if the file is invalid
   */
  public Users(Path file, Consumer<String> log) {
    this.file = file;
    this.log = log;
    account = null;
    readAt = changedAt();
    ofFile = UserFile.read(file);
  }

  /** Users of a broker that only this host can reach. */
  public Users(LocalAccount account) {
    file = null;
    log = line -> {};
    this.account = account;
    ofFile = Map.of();
    add(account.own().user());
    add(account.anybody());
  }

  /**
   * Whether users have passwords, which take time to check; otherwise the account's token is used.
   */
  public boolean havePasswords() {
    return account == null;
  }

  /**
   * User for a name and an account's token. The token is long and random, so guessing needs no rate
   * limit.
   *
   * @param name empty if none was given
   * @return empty if the token is wrong
   */
  public Optional<User> ofAccount(String name, byte[] token) {
    if (name.isEmpty()) {
      return Optional.of(account.anybody());
    }
    char[] said = new String(token, StandardCharsets.UTF_8).toCharArray();
    return named(name).filter(user -> user.password().matches(said));
  }

  /** The user of this name, or empty. */
  public Optional<User> named(String name) {
    User temporary = ofThisRun.get(name);
    return Optional.ofNullable(temporary != null ? temporary : ofFile.get(name));
  }

  /** Adds a temporary user, valid until the broker ends. */
  public void add(User user) {
    ofThisRun.put(user.name(), user);
  }

  /**
   * Reloads the file if it has changed; an invalid one is reported and the previous users are kept.
   */
  public synchronized void refresh() {
    if (file == null) {
      return;
    }
    FileTime changed = changedAt();
    if (changed.equals(readAt)) {
      return;
    }
    readAt = changed;
    try {
      ofFile = UserFile.read(file);
      log.accept("users reloaded: " + ofFile.size() + " in " + file);
    } catch (BadInputException e) {
      log.accept("users unchanged: " + e.getMessage());
    }
  }

  /** {@link #refresh} on a disk thread, because a network thread must not wait for the disk. */
  public void refreshLater() {
    if (isLooking.compareAndSet(false, true)) {
      DISK.execute(
          () -> {
            try {
              refresh();
            } finally {
              isLooking.set(false);
            }
          });
    }
  }

  private FileTime changedAt() {
    try {
      return Files.getLastModifiedTime(file);
    } catch (IOException e) {
      return FileTime.fromMillis(0); // missing: reading it reports this
    }
  }
}
