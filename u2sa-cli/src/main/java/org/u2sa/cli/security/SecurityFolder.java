package org.u2sa.cli.security;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.BadInputException;
import picocli.CommandLine.Option;

/** The folder created by {@code u2sa security init}, and the option for it. */
final class SecurityFolder {
  @Option(
      names = "--dir",
      paramLabel = "DIR",
      defaultValue = "security",
      description = "The folder created by u2sa security init. Default: ${DEFAULT-VALUE}.")
  private Path path;

  SecurityDirectory existing() {
    SecurityDirectory directory = new SecurityDirectory(path);
    if (!Files.isRegularFile(directory.users())) {
      throw new BadInputException(
          "--dir " + path + ": there is no users.txt; ./u2sa security init " + path + " makes one");
    }
    directory.requireClosed();
    return directory;
  }

  /** Creates a folder accessible to its owner only, or restricts an existing one. */
  static void makePrivate(Path folder) throws IOException {
    Files.createDirectories(folder);
    if (folder.getFileSystem().supportedFileAttributeViews().contains("posix")) {
      Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwx------"));
    }
  }
}
