package org.u2sa.network;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;

/** Where the scripts and the vehicles' files are. */
final class Repository {
  private Repository() {}

  static Path folder() {
    Path folder = Paths.get("").toAbsolutePath();
    while (!Files.isDirectory(folder.resolve("config/cessna"))) {
      folder = folder.getParent();
    }
    return folder;
  }
}
