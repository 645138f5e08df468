package org.u2sa.messages.schema;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;

/** Finds the repository's files from a module's tests. */
final class Repository {
  private Repository() {}

  static Path file(String relative) {
    Path folder = Paths.get("").toAbsolutePath();
    while (!Files.exists(folder.resolve("docs/wire-protocol.md"))) {
      folder = folder.getParent();
      if (folder == null) {
        throw new IllegalStateException("no docs/wire-protocol.md above the working directory");
      }
    }
    return folder.resolve(relative);
  }
}
