package org.u2sa.spark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.u2sa.interfaces.BadInputException;

/** Keeps a cluster's secrets where only their owner can read them. */
final class ClusterSecrets {
  private static final Set<PosixFilePermission> OTHERS =
      EnumSet.of(
          PosixFilePermission.GROUP_READ,
          PosixFilePermission.GROUP_WRITE,
          PosixFilePermission.OTHERS_READ,
          PosixFilePermission.OTHERS_WRITE);

  private ClusterSecrets() {}

  /**
   * Refuses secrets that other accounts of this host can read.
   *
   * @param javaOptions options of this process
   * @throws BadInputException if one is among the options, or in a file that others may access
   */
  static void check(Path file, List<String> javaOptions) {
    for (String option : javaOptions) {
      String name = option.split("=", 2)[0];
      if (name.startsWith("-Dspark.") && isSecret(name)) {
        throw new BadInputException(
            name
                + " in U2SA_JAVA_OPTS: every account of this host can read it; write it into "
                + file
                + " with mode 600 instead, without -D");
      }
    }
    try {
      if (ClusterProperties.read(file).stringPropertyNames().stream()
              .anyMatch(ClusterSecrets::isSecret)
          && isOpen(file)) {
        throw new BadInputException(
            file + " has a secret, and users other than its owner may read it; chmod 600 it");
      }
    } catch (IOException | IllegalArgumentException e) {
      throw new BadInputException(file + " cannot be read: " + e.getMessage(), e);
    }
  }

  private static boolean isSecret(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return lower.contains("secret") || lower.contains("password");
  }

  private static boolean isOpen(Path file) throws IOException {
    if (!file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
      return false; // non-POSIX permissions, not visible to Java
    }
    return Files.getPosixFilePermissions(file).stream().anyMatch(OTHERS::contains);
  }
}
