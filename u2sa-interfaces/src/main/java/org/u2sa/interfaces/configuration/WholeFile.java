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
import java.nio.file.attribute.PosixFilePermissions;

/** Replaces files atomically: after a power cut the old or the new file exists. */
public final class WholeFile {
  private static final String SUFFIX = ".tmp";

  private WholeFile() {}

  /**
   * Replaces the content of an existing file, preserving owner, group, permissions and links to it.
   * Call under the folder's lock: other temporary files are deleted as leftovers of a power cut.
   *
   * @throws IOException if that fails; the old content is kept
   */
  static void replace(Path file, byte[] content) throws IOException {
    boolean interrupted = Thread.interrupted(); // would close the channel; restored below
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
    Path temporary = Files.createTempFile(directory, prefix, SUFFIX); // private to its owner
    try {
      FileOwnership.copy(target, temporary);
      fillAndRename(temporary, content, target);
    } finally {
      Files.deleteIfExists(temporary);
    }
  }

  /**
   * Fills an empty file beside the target, syncs it, and renames it to the target.
   *
   * @throws IOException if that fails; the old file, if any, is kept
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

  /** Creates an empty file that only its owner may read or write. */
  public static void createPrivate(Path file) throws IOException {
    if (file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
      Files.createFile(
          file, PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------")));
    } else {
      Files.createFile(file);
    }
  }

  static void write(FileChannel out, byte[] content) throws IOException {
    ByteBuffer left = ByteBuffer.wrap(content);
    while (left.hasRemaining()) {
      out.write(left);
    }
  }

  /** Syncs a directory so that created and renamed names reach the disk. */
  // Some systems cannot open a directory (Windows); files are still atomic there, but the latest
  // change may be lost in a power cut.
  static void sync(Path directory) {
    boolean interrupted = Thread.interrupted(); // would close the channel; restored below
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

  // Leftovers that cannot be listed or deleted do not prevent the change.
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

  static final class FileOwnership {
    private FileOwnership() {}

    /**
     * Copies owner, group and permissions to a private file of this process; permissions are never
     * wider in between than at the end.
     *
     * @throws IOException if this user may not set the owner or group
     */
    static void copy(Path from, Path to) throws IOException {
      PosixFileAttributeView view = Files.getFileAttributeView(to, PosixFileAttributeView.class);
      if (view == null) {
        return; // non-POSIX permissions, not visible to Java
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
                "%s belongs to %s:%s, and its ownership could not be kept: change it as that user",
                from, wanted.owner().getName(), wanted.group().getName()),
            e);
      }
      if (!now.permissions().equals(wanted.permissions())) {
        view.setPermissions(wanted.permissions());
      }
    }
  }
}
