package org.u2sa.cli.run;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.stream.Stream;
import org.u2sa.interfaces.BadInputException;

/**
 * Claims a folder of logs and saved states for one system while any of its processes runs: two
 * systems would overwrite each other's saved states. The operating system releases it, even after a
 * kill.
 */
final class LogFolderClaim implements AutoCloseable {
  private static final String FILE = ".system";
  private static final int MAX_BYTES = 1_000;
  private static final long LOCKED_BYTE = 1 << 20; // beyond the text, which stays readable

  private final FileChannel channel; // null if the folder cannot be locked
  private final Path unused; // a folder that did not exist before; null otherwise

  private LogFolderClaim(FileChannel channel, Path unused) {
    this.channel = channel;
    this.unused = unused;
  }

  /**
   * Claims the folder, which is created if absent. Where that is impossible, such as on a disk that
   * is read only, nothing is claimed.
   *
   * @throws BadInputException if another system is using it, or its mark is a symbolic link
   */
  @SuppressWarnings("resource") // kept open until close
  static LogFolderClaim of(Path folder, String systemId) {
    FileChannel channel = null;
    Path unused = Files.exists(folder) ? null : folder;
    try {
      Files.createDirectories(folder);
      if (Files.isSymbolicLink(folder.resolve(FILE))) {
        throw new BadInputException(
            String.format(
                "--logs %s: %s in it is a symbolic link; remove it, or choose another folder",
                folder, FILE));
      }
      channel =
          FileChannel.open(
              folder.resolve(FILE),
              StandardOpenOption.CREATE,
              StandardOpenOption.READ,
              StandardOpenOption.WRITE,
              LinkOption.NOFOLLOW_LINKS); // a link would have another file truncated
      String owner = owner(channel, systemId);
      if (owner.equals(systemId)) {
        return new LogFolderClaim(channel, unused);
      }
      channel.close();
      throw new BadInputException(
          String.format(
              "--logs %s: system %s, which is running, writes its logs and saved states there; choose another folder for system %s",
              folder, owner, systemId));
    } catch (IOException e) {
      return new LogFolderClaim(channel, unused);
    }
  }

  /** Whose the folder is: ours if it is free, or already ours. */
  private static String owner(FileChannel channel, String systemId) throws IOException {
    try (FileLock alone = channel.tryLock(LOCKED_BYTE, 1, false)) {
      if (alone != null) {
        ByteBuffer id = ByteBuffer.wrap(systemId.getBytes(StandardCharsets.UTF_8));
        channel.truncate(0);
        channel.write(id, 0);
      }
    } catch (OverlappingFileLockException e) {
      return text(channel); // another run of this process
    }
    channel.tryLock(LOCKED_BYTE, 1, true);
    return text(channel);
  }

  private static String text(FileChannel channel) throws IOException {
    ByteBuffer text = ByteBuffer.allocate(MAX_BYTES);
    channel.read(text, 0);
    return new String(text.array(), 0, text.position(), StandardCharsets.UTF_8);
  }

  /** Releases the folder, and deletes it if nothing else was ever written to it. */
  @Override
  public void close() {
    try {
      if (channel != null) {
        channel.close();
      }
      if (unused != null && isUnused()) {
        Files.deleteIfExists(unused.resolve(FILE));
        Files.deleteIfExists(unused);
      }
    } catch (IOException e) {
      return; // the process ends anyway
    }
  }

  private boolean isUnused() throws IOException {
    try (Stream<Path> files = Files.list(unused)) {
      return files.allMatch(file -> file.endsWith(FILE));
    }
  }
}
