package org.u2sa.cli.run;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
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

  private LogFolderClaim(FileChannel channel) {
    this.channel = channel;
  }

  /**
   * Claims the folder, which is created if absent. Where that is impossible, such as on a disk that
   * is read only, nothing is claimed.
   *
   * @throws BadInputException if another system is using it
   */
  @SuppressWarnings("resource") // kept open until close
  static LogFolderClaim of(Path folder, String systemId) {
    FileChannel channel = null;
    try {
      Files.createDirectories(folder);
      channel =
          FileChannel.open(
              folder.resolve(FILE),
              StandardOpenOption.CREATE,
              StandardOpenOption.READ,
              StandardOpenOption.WRITE);
      String owner = owner(channel, systemId);
      if (owner.equals(systemId)) {
        return new LogFolderClaim(channel);
      }
      channel.close();
      throw new BadInputException(
          String.format(
              "--logs %s: system %s, which is running, writes its logs and saved states there; choose another folder for system %s",
              folder, owner, systemId));
    } catch (IOException e) {
      return new LogFolderClaim(channel);
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

  @Override
  public void close() {
    try {
      if (channel != null) {
        channel.close();
      }
    } catch (IOException e) {
      return; // the process ends anyway
    }
  }
}
