package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.util.EnumSet;
import java.util.Set;
import org.u2sa.interfaces.BadInputException;

/** Permission checks of files with secrets. */
final class SecretFiles {
  private static final Set<PosixFilePermission> OTHERS =
      EnumSet.of(
          PosixFilePermission.OTHERS_READ,
          PosixFilePermission.OTHERS_WRITE,
          PosixFilePermission.GROUP_READ,
          PosixFilePermission.GROUP_WRITE);

  private SecretFiles() {}

  /**
   * Rejects a file that is accessible to others, or not a regular file.
   *
   * @param variable names the file in the message
   * @throws BadInputException if it is rejected; a missing file is reported when it is read
   */
  static void requireClosed(String variable, Path file) {
    refuse(variable, file, OTHERS, "use it; chmod 600 it");
  }

  /**
   * Rejects a file that is world-writable, or not a regular file.
   *
   * @throws BadInputException as {@link #requireClosed}
   */
  static void requireOwnersWord(String variable, Path file) {
    refuse(variable, file, EnumSet.of(PosixFilePermission.OTHERS_WRITE), "write it; chmod o-w it");
  }

  private static void refuse(
      String variable, Path file, Set<PosixFilePermission> refused, String what) {
    if (!Files.exists(file)) {
      return;
    }
    if (!Files.isRegularFile(file)) {
      throw new BadInputException(variable + " \"" + file + "\" is not a regular file");
    }
    if (!file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
      return; // non-POSIX permissions, not visible to Java
    }
    try {
      Set<PosixFilePermission> open = EnumSet.noneOf(PosixFilePermission.class);
      open.addAll(Files.getPosixFilePermissions(file));
      open.retainAll(refused);
      if (!open.isEmpty()) {
        throw new BadInputException(
            variable + " \"" + file + "\": users other than its owner may " + what);
      }
    } catch (IOException e) {
      throw new BadInputException(
          variable + " \"" + file + "\": its permissions cannot be read: " + e, e);
    }
  }
}
