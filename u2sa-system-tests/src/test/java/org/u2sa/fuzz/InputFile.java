package org.u2sa.fuzz;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A file with the fuzzer's bytes, for readers that take files; gone when closed. */
public final class InputFile implements AutoCloseable {
  private final Path path;

  private InputFile(Path path) {
    this.path = path;
  }

  /** A new file of that content. */
  public static InputFile of(byte[] content) {
    try {
      Path path = Files.createTempFile("u2sa-fuzz", ".xml");
      Files.write(path, content);
      return new InputFile(path);
    } catch (IOException e) {
      throw new UncheckedIOException("no file for the input", e);
    }
  }

  /** Where it is. */
  public Path path() {
    return path;
  }

  @Override
  public void close() {
    try {
      Files.deleteIfExists(path);
    } catch (IOException e) {
      throw new UncheckedIOException("the input's file stays", e);
    }
  }
}
