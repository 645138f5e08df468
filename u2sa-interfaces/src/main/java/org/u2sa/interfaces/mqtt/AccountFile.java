package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.u2sa.interfaces.configuration.WholeFile;

/**
 * A file for the other programs of this account, in each of its {@link AccountFolders}, readable by
 * the account only. Rewritten if it disappears, because the system removes such folders with an
 * account's last session. Thread-safe.
 */
public final class AccountFile implements AutoCloseable {
  private static final long LOOK_MS = 1_000;

  private final AccountFolders folders;
  private final String name;
  private final byte[] content;
  private final Consumer<String> failures;
  private final Map<Path, String> told = new HashMap<>(); // last failure; guarded by this
  private final ScheduledExecutorService timer;
  private boolean closed; // guarded by this

  /**
   * Writes the file, and keeps it until {@link #close}.
   *
   * @param failures receives a line for each folder where it cannot be written, once per cause
   */
  public AccountFile(
      AccountFolders folders, String name, String content, Consumer<String> failures) {
    this.folders = folders;
    this.name = name;
    this.content = content.getBytes(StandardCharsets.UTF_8);
    this.failures = failures;
    folders.all().forEach(this::write);
    timer =
        Executors.newSingleThreadScheduledExecutor(
            task -> {
              Thread thread = new Thread(task, "u2sa-account-file");
              thread.setDaemon(true);
              return thread;
            });
    timer.scheduleWithFixedDelay(this::writeMissing, LOOK_MS, LOOK_MS, TimeUnit.MILLISECONDS);
  }

  /** Rewrites the file if it is missing. Called every second. */
  synchronized void writeMissing() {
    if (closed) {
      return;
    }
    for (Path folder : folders.all()) {
      // A file with other content belongs to a later program, such as another broker at
      // the same port.
      if (!Files.exists(folder.resolve(name), LinkOption.NOFOLLOW_LINKS)) {
        write(folder);
      }
    }
  }

  private synchronized void write(Path folder) {
    String failure = "";
    try {
      AccountFolders.prepare(folder);
      replace(folder.resolve(name));
    } catch (IOException e) {
      failure = folder + ": " + e;
    }
    if (!failure.equals(told.put(folder, failure)) && !failure.isEmpty()) {
      failures.accept(failure);
    }
  }

  /** Writes it whole; it never exists with wider permissions. */
  private void replace(Path file) throws IOException {
    Path beside = file.resolveSibling(name + ".new");
    Files.deleteIfExists(beside);
    WholeFile.createPrivate(beside);
    WholeFile.fillAndRename(beside, content, file);
  }

  /** Removes the file, unless a later program has replaced it. */
  @Override
  public void close() {
    timer.shutdownNow();
    synchronized (this) {
      closed = true;
      folders.all().forEach(this::remove);
    }
  }

  private void remove(Path folder) {
    Path file = folder.resolve(name);
    try {
      if (Files.isRegularFile(file) && Arrays.equals(Files.readAllBytes(file), content)) {
        Files.delete(file);
      }
    } catch (IOException e) {
      failures.accept(file + ": cannot be removed: " + e);
    }
  }
}
