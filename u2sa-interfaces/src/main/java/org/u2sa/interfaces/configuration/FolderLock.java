package org.u2sa.interfaces.configuration;

import java.io.Closeable;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.locks.LockSupport;

/**
 * Lock for writers of a folder's configuration files, within and across processes; released when
 * its holder dies. The lock file is never deleted, because two writers could then lock different
 * files of the same name.
 */
final class FolderLock implements Closeable {
  private static final String NAME = ".configuration.lock";
  private static final long PAUSE_NANOS = 1_000_000L;
  private static final int ATTEMPTS = 2_000; // a holder needs milliseconds; 2 s means a fault

  private final FileChannel channel;
  private final FileLock lock;

  private FolderLock(FileChannel channel, FileLock lock) {
    this.channel = channel;
    this.lock = lock;
  }

  /**
   * @throws IOException if another writer holds the lock for 2 s, the thread is interrupted, or the
   *     lock file cannot be created
   */
  static FolderLock take(Path folder) throws IOException {
    boolean interrupted = Thread.interrupted(); // an earlier interrupt must not end the wait
    try {
      return open(folder);
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private static FolderLock open(Path folder) throws IOException {
    Path file = folder.resolve(NAME);
    if (Files.exists(file, LinkOption.NOFOLLOW_LINKS)
        && !Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
      throw new IOException(
          file + " is not a regular file; remove it"); // opening a pipe would block
    }
    FileChannel channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
    try {
      return new FolderLock(channel, await(channel, folder));
    } catch (IOException | RuntimeException e) {
      channel.close();
      throw e;
    }
  }

  private static FileLock await(FileChannel channel, Path folder) throws IOException {
    for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
      FileLock lock = attempt(channel);
      if (lock != null) {
        return lock;
      }
      LockSupport.parkNanos(PAUSE_NANOS);
      if (Thread.interrupted()) {
        Thread.currentThread().interrupt();
        throw new IOException("interrupted while another writer was at work in " + folder);
      }
    }
    throw new IOException(
        folder.resolve(NAME) + " is locked: another writer has held it for 2 s; try again");
  }

  // tryLock returns null for a lock held by another process, and throws for one held by this
  // process.
  private static FileLock attempt(FileChannel channel) throws IOException {
    try {
      return channel.tryLock();
    } catch (OverlappingFileLockException e) {
      return null;
    }
  }

  @Override
  public void close() throws IOException {
    lock.release();
    channel.close();
  }
}
