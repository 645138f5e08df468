package org.u2sa.gcs.security;

import java.nio.file.Files;
import java.nio.file.Path;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.BadInputException;
import picocli.CommandLine.Option;

/** The option that names the folder which {@code u2sa security init} made. */
final class SecurityFolder {
  @Option(
      names = "--dir",
      paramLabel = "DIR",
      defaultValue = "security",
      description = "The folder that u2sa security init made. Default: ${DEFAULT-VALUE}.")
  private Path path;

  SecurityDirectory existing() {
    SecurityDirectory directory = new SecurityDirectory(path);
    if (!Files.isRegularFile(directory.users())) {
      throw new BadInputException(
          "--dir " + path + ": there is no users.txt; ./u2sa security init " + path + " makes it");
    }
    directory.requireClosed();
    return directory;
  }
}
