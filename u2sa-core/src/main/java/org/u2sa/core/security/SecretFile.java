package org.u2sa.core.security;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipal;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.WholeFile;

/** Files that only their owner may read: keys, passwords, users. */
public final class SecretFile {
  private static final Set<PosixFilePermission> OWNER_ONLY =
      PosixFilePermissions.fromString("rw-------");

  private SecretFile() {}

  /**
   * Writes the file atomically; it never exists with wider permissions.
   *
   * @throws BadInputException if it cannot be written
   */
  public static void write(Path file, byte[] content) {
    Path beside = file.resolveSibling(file.getFileName() + ".new");
    try {
      Files.deleteIfExists(beside);
      if (isPosix(file)) {
        Files.createFile(beside, PosixFilePermissions.asFileAttribute(OWNER_ONLY));
      } else {
        Files.createFile(beside);
      }
      giveToOwnerOf(Files.exists(file) ? file : file.toAbsolutePath().getParent(), beside);
      WholeFile.fillAndRename(beside, content, file);
    } catch (IOException e) {
      throw new BadInputException(file + ": cannot be written: " + e, e);
    }
  }

  /** Preserves the owner when root writes another user's file; throws if this user may not. */
  private static void giveToOwnerOf(Path file, Path own) throws IOException {
    if (!isPosix(file)) {
      return;
    }
    UserPrincipal owner = Files.getOwner(file);
    if (!owner.equals(Files.getOwner(own))) {
      try {
        Files.setOwner(own, owner);
      } catch (IOException e) {
        throw new IOException(
            "it belongs to "
                + owner.getName()
                + ", and its ownership could not be kept: run this as that user",
            e);
      }
    }
  }

  /** Problem with a folder's permissions; empty if only its owner may add and remove files. */
  public static Optional<String> tooOpenFolder(Path folder) {
    try {
      if (!isPosix(folder)) {
        return Optional.empty(); // permissions that Java cannot read
      }
      Set<PosixFilePermission> permissions = Files.getPosixFilePermissions(folder);
      boolean writable =
          permissions.contains(PosixFilePermission.GROUP_WRITE)
              || permissions.contains(PosixFilePermission.OTHERS_WRITE);
      return writable
          ? Optional.of(folder + ": users other than its owner may replace its files; chmod 700 it")
          : Optional.empty();
    } catch (IOException e) {
      return Optional.of(folder + ": its permissions cannot be read: " + e);
    }
  }

  /** Problem with the file's permissions; empty if only its owner may read and write it. */
  public static Optional<String> tooOpen(Path file) {
    try {
      if (!isPosix(file)) {
        return Optional.empty(); // permissions that Java cannot read
      }
      Set<PosixFilePermission> others =
          new HashSet<>(Files.getPosixFilePermissions(file, LinkOption.NOFOLLOW_LINKS));
      others.removeAll(EnumSet.of(PosixFilePermission.OWNER_READ, PosixFilePermission.OWNER_WRITE));
      return others.isEmpty()
          ? Optional.empty()
          : Optional.of(file + ": users other than its owner may use it; chmod 600 it");
    } catch (IOException e) {
      return Optional.of(file + ": its permissions cannot be read: " + e);
    }
  }

  private static boolean isPosix(Path file) {
    return file.getFileSystem().supportedFileAttributeViews().contains("posix");
  }
}
