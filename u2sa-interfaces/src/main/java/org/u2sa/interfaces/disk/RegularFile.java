package org.u2sa.interfaces.disk;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;

/** Says in words what is wrong with a path that should be a regular file. */
public final class RegularFile {
  private static final int TYPE_MASK = 0xF000; // S_IFMT of POSIX
  private static final int PIPE = 0x1000; // S_IFIFO

  private RegularFile() {}

  /** What the path is instead, such as "no such file"; empty for a regular file. */
  public static Optional<String> problem(Path file) {
    if (Files.isRegularFile(file)) {
      return Optional.empty();
    }
    if (Files.isDirectory(file)) {
      return Optional.of("is a folder");
    }
    if (Files.exists(file)) {
      return Optional.of("is not a regular file, but a device, pipe or socket");
    }
    return Optional.of(Files.notExists(file) ? "no such file" : "cannot be accessed");
  }

  /**
   * Rejects a named pipe, since opening one waits for its other end.
   *
   * @throws IOException naming it
   */
  public static void refusePipe(Path file) throws IOException {
    if (Files.exists(file)
        && !Files.isRegularFile(file)
        && file.getFileSystem().supportedFileAttributeViews().contains("unix")
        && ((int) Files.getAttribute(file, "unix:mode") & TYPE_MASK) == PIPE) {
      throw new IOException(file + " is a named pipe; remove it");
    }
  }

  /**
   * Rejects anything but a regular file.
   *
   * @param expected what is expected, such as "a recording (MCAP)"
   * @throws BadInputException naming the path
   */
  public static void require(Path file, String expected) {
    problem(file)
        .ifPresent(
            what -> {
              throw new BadInputException(file + ": " + what + "; expected " + expected);
            });
  }
}
