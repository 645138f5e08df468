package org.u2sa.interfaces.configuration;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.interfaces.BadInputException;

/**
 * Detects changes of a file since it was loaded. The loaded content stays in force, but a restart
 * of the service would load different content or fail. Not thread-safe.
 */
public final class LoadedFile {
  private record Stamp(FileTime modified, long bytes, Object key) {}

  private final Path file;
  private final Consumer<Path> reader;
  private final Optional<Stamp> loaded;
  private Optional<Stamp> judged;
  private Optional<String> fault = Optional.empty();

  /**
   * Records the file's current state; call it before reading the file.
   *
   * @param reader re-reads the file, and throws a {@link BadInputException} if it is invalid
   */
  public LoadedFile(Path file, Consumer<Path> reader) {
    this.file = file;
    this.reader = reader;
    loaded = stamp();
    judged = loaded;
  }

  private Optional<Stamp> stamp() {
    try {
      BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
      return Optional.of(new Stamp(now.lastModifiedTime(), now.size(), now.fileKey()));
    } catch (IOException e) {
      return Optional.empty(); // the reader reports the reason
    }
  }

  /** Current fault of the file, starting with its name; empty if unchanged. */
  public Optional<String> fault() {
    Optional<Stamp> now = stamp();
    if (!now.equals(judged)) { // re-read only after a change
      judged = now;
      fault = now.equals(loaded) ? Optional.empty() : Optional.of(judge());
    }
    return fault;
  }

  private String judge() {
    try {
      reader.accept(file);
      return file
          + ": was changed after it was loaded; the loaded values stay in force until the "
          + "service is restarted";
    } catch (BadInputException e) {
      return e.getMessage() + "; the previously loaded values stay in force";
    }
  }
}
