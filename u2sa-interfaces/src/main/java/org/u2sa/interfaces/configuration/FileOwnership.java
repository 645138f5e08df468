package org.u2sa.interfaces.configuration;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFileAttributes;

/** Whose a file is and who may use it, passed on to the file that takes its place. */
final class FileOwnership {
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
          from
              + " belongs to "
              + wanted.owner().getName()
              + ":"
              + wanted.group().getName()
              + " and could not stay theirs: change it as that user",
          e);
    }
    if (!now.permissions().equals(wanted.permissions())) {
      view.setPermissions(wanted.permissions());
    }
  }
}
