package org.u2sa.interfaces.configuration;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFileAttributes;

/**
 * Replaces a file as a whole: after a power cut there is the old or the new one. Written beside it,
 * synced, renamed over it.
 */
public final class WholeFile {
  private static final String SUFFIX = ".tmp";

  private WholeFile() {}

  /**
   * Replaces the content of {@code file}, which exists; its owner, group and permissions stay, a
   * link to it stays one. To be called under the folder's lock: other writers' temporary files are
   * taken for leftovers of a power cut.
   *
   * @throws IOException if that failed: then the old content stands
   */
  static void replace(Path file, byte[] content) throws IOException {
    boolean interrupted = Thread.interrupted(); // would close the channel; given back below
    try {
      replaceTarget(file.toRealPath(), content);
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private static void replaceTarget(Path target, byte[] content) throws IOException {
    Path directory = target.getParent();
    String prefix = "." + target.getFileName() + ".";
    deleteLeftovers(directory, prefix);
    Path temporary = Files.createTempFile(directory, prefix, SUFFIX); // its owner's alone
    try {
      FileOwnership.copy(target, temporary);
      fillAndRename(temporary, content, target);
    } finally {
      Files.deleteIfExists(temporary);
    }
  }

  /**
   * Fills {@code temporary}, which exists beside {@code target} and is empty, and renames it to
   * that once its content is on the disk.
   *
   * @throws IOException if that failed: then the old file stands, or none
   */
  public static void fillAndRename(Path temporary, byte[] content, Path target) throws IOException {
    try (FileChannel out = FileChannel.open(temporary, StandardOpenOption.WRITE)) {
      write(out, content);
      out.force(true);
    }
    Files.move(
        temporary, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    sync(target.toAbsolutePath().getParent());
  }

  /** Writes all of it at the channel's position. */
  static void write(FileChannel out, byte[] content) throws IOException {
    ByteBuffer left = ByteBuffer.wrap(content);
    while (left.hasRemaining()) {
      out.write(left);
    }
  }

  /** Has the names of a directory reach the disk: of files that were renamed or made. */
  // Not every system can open a directory (Windows cannot); there the files are whole all the
  // same, only the newest change may be lost with the power.
  static void sync(Path directory) {
    boolean interrupted = Thread.interrupted(); // would close the channel; given back below
    try (FileChannel channel = FileChannel.open(directory, StandardOpenOption.READ)) {
      channel.force(true);
    } catch (IOException e) {
      return;
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  // What cannot be listed or deleted stays: it is no reason to refuse the change.
  private static void deleteLeftovers(Path directory, String prefix) {
    try (DirectoryStream<Path> leftovers =
        Files.newDirectoryStream(directory, entry -> isLeftover(entry, prefix))) {
      for (Path leftover : leftovers) {
        Files.deleteIfExists(leftover);
      }
    } catch (IOException | DirectoryIteratorException e) {
      return;
    }
  }

  private static boolean isLeftover(Path entry, String prefix) {
    String name = entry.getFileName().toString();
    return name.startsWith(prefix) && name.endsWith(SUFFIX);
  }

  /** Whose a file is and who may use it, passed on to the file that takes its place. */
  static final class FileOwnership {
    private FileOwnership() {}

    /**
     * Gives {@code to}, which is this process's own and closed to others, owner, group and
     * permissions of {@code from}. Never wider on the way than in the end.
     *
     * @throws IOException if this user may not give it to the owner or the group
     */
    static void copy(Path from, Path to) throws IOException {
      PosixFileAttributeView view = Files.getFileAttributeView(to, PosixFileAttributeView.class);
      if (view == null) {
        return; // another kind of permissions, which Java does not tell
      }
      PosixFileAttributes wanted = Files.readAttributes(from, PosixFileAttributes.class);
      PosixFileAttributes now = view.readAttributes();
      try {
        if (!now.group().equals(wanted.group())) {
          view.setGroup(wanted.group());
        }
        if (!now.owner().equals(wanted.owner())) {
          view.setOwner(wanted.owner());
        }
      } catch (IOException e) {
        throw new IOException(
            String.format(
                "%s belongs to %s:%s and could not stay theirs: change it as that user",
                from, wanted.owner().getName(), wanted.group().getName()),
            e);
      }
      if (!now.permissions().equals(wanted.permissions())) {
        view.setPermissions(wanted.permissions());
      }
    }
  }
}
