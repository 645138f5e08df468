package org.u2sa.interfaces;

import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFileAttributeView;

/**
 * Replaces a file as a whole: after a power cut there is the old or the new one. Written beside it,
 * synced, renamed over it.
 */
final class WholeFile {
  private static final String SUFFIX = ".tmp";

  private WholeFile() {}

  /**
   * Replaces the content of {@code file}, which exists; its permissions stay, a link to it stays
   * one. To be called under the folder's lock: other writers' temporary files are taken for
   * leftovers of a power cut.
   *
   * @throws IOException if that failed: then the old content stands
   */
  static void replace(Path file, byte[] content) throws IOException {
    Path target = file.toRealPath();
    Path directory = target.getParent();
    String prefix = "." + target.getFileName() + ".";
    deleteLeftovers(directory, prefix);
    Path temporary = Files.createTempFile(directory, prefix, SUFFIX);
    try {
      copyPermissions(target, temporary);
      try (FileOutputStream out = new FileOutputStream(temporary.toFile())) {
        out.write(content);
        out.getFD().sync();
      }
      Files.move(
          temporary, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
      sync(directory);
    } finally {
      Files.deleteIfExists(temporary);
    }
  }

  private static void copyPermissions(Path from, Path to) throws IOException {
    PosixFileAttributeView view = Files.getFileAttributeView(from, PosixFileAttributeView.class);
    if (view != null) {
      Files.setPosixFilePermissions(to, view.readAttributes().permissions());
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
    File[] leftovers =
        directory
            .toFile()
            .listFiles(
                entry -> entry.getName().startsWith(prefix) && entry.getName().endsWith(SUFFIX));
    for (File leftover : leftovers == null ? new File[0] : leftovers) {
      leftover.delete();
    }
  }
}
