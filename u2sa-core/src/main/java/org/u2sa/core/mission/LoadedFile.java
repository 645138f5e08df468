package org.u2sa.core.mission;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.interfaces.BadInputException;

/**
 * A loaded file: tells when it has changed since. What was loaded stays in force, but a restart of
 * the service would load something else, or fail. Belongs to one thread.
 */
public final class LoadedFile {
  private record Stamp(FileTime modified, long bytes, Object key) {}

  private final Path file;
  private final Consumer<Path> reader;
  private final Optional<Stamp> loaded;
  private Optional<Stamp> judged;
  private Optional<String> fault = Optional.empty();

  /**
   * Takes note of the file as it is now; to be called before it is read.
   *
   * @param reader reads it once more, and throws a {@link BadInputException} if it is wrong
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
      return Optional.empty(); // the reader says why
    }
  }

  /** What is wrong with the file now, beginning with its name; empty if it is as it was loaded. */
  public Optional<String> fault() {
    Optional<Stamp> now = stamp();
    if (!now.equals(judged)) { // read again only then
      judged = now;
      fault = now.equals(loaded) ? Optional.empty() : Optional.of(judge());
    }
    return fault;
  }

  private String judge() {
    try {
      reader.accept(file);
      return file
          + ": was changed after it was loaded; what was loaded stays in force until the "
          + "service is restarted";
    } catch (BadInputException e) {
      return e.getMessage() + "; what was loaded before stays in force";
    }
  }
}
