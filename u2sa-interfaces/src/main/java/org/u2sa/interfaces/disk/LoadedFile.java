package org.u2sa.interfaces.disk;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

/**
 * A file as loaded, which detects later changes. The loaded content stays in force, but a restart
 * of the service would load different content or fail. In real time a {@link DiskThread} looks at
 * the file, so that its user does not wait for a disk that hangs; in simulated time the caller
 * does. For use by one thread.
 */
public final class LoadedFile<T> {
  private static final DiskThread DISK = new DiskThread("u2sa-files");
  private static final long LOADS_WITHIN_MS = 10_000; // a busy machine starts slowly
  private static final long READS_WITHIN_MS = 1_000;
  private static final long LOOKS_WITHIN_MICROS = 5 * Clock.MICROS_PER_SECOND;

  private record Stamp(FileTime modified, long bytes, Object key) {}

  private final Path file;
  private final Function<Path, T> reader;
  private final Clock clock;
  private final Clock stopwatch;
  private final AtomicLong askedMicros = new AtomicLong(Clock.NEVER); // NEVER: no look is pending
  private final T content;
  private Optional<Stamp> loaded; // this and the next belong to the thread that looks
  private Optional<Stamp> judged;
  private volatile Optional<String> fault = Optional.empty();

  /**
   * Loads a file.
   *
   * @param reader reads the file, and throws a {@link BadInputException} if it is invalid
   * @throws BadInputException if the reader throws it, or the disk does not answer within 10 s
   */
  public LoadedFile(Path file, Function<Path, T> reader, Clock clock) {
    this(file, reader, clock, new SystemClock());
  }

  /**
   * @param clock the user's, which is never read: in a repeated execution every reading is one of
   *     the recorded ones
   * @param stopwatch measures how long a look takes
   */
  LoadedFile(Path file, Function<Path, T> reader, Clock clock, Clock stopwatch) {
    this.file = file;
    this.reader = reader;
    this.clock = clock;
    this.stopwatch = stopwatch;
    content = within(LOADS_WITHIN_MS, file, this::load, clock);
  }

  private T load(Path path) {
    loaded = stamp(); // first: a change while it is read is one
    judged = loaded;
    return reader.apply(path);
  }

  /**
   * Reads a file that is not watched.
   *
   * @throws BadInputException if the reader throws it, or the disk does not answer within 1 s
   */
  public static <T> T read(Path file, Function<Path, T> reader, Clock clock) {
    return within(READS_WITHIN_MS, file, reader, clock);
  }

  private static <T> T within(long ms, Path file, Function<Path, T> reader, Clock clock) {
    if (clock.isSimulated()) {
      return reader.apply(file);
    }
    try {
      return DISK.call(() -> reader.apply(file), ms);
    } catch (IOException e) {
      throw new BadInputException(file + ": " + e.getMessage(), e);
    }
  }

  /** The content as loaded. */
  public T content() {
    return content;
  }

  private Optional<Stamp> stamp() {
    try {
      BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
      return Optional.of(new Stamp(now.lastModifiedTime(), now.size(), now.fileKey()));
    } catch (IOException e) {
      return Optional.empty(); // the reader reports the reason
    }
  }

  /**
   * Fault of the file, starting with its name; empty if unchanged. In real time it is what the last
   * look found, and the next one begins; or that a disk has not answered for 5 s.
   */
  public Optional<String> fault() {
    if (clock.isSimulated()) {
      look();
      return fault;
    }
    long now = stopwatch.micros();
    if (askedMicros.compareAndSet(Clock.NEVER, now)) {
      DISK.execute(this::look);
    }
    return now - askedMicros.get() > LOOKS_WITHIN_MICROS
        ? Optional.of(file + ": a disk does not answer; the loaded values stay in force")
        : fault;
  }

  private void look() {
    try {
      Optional<Stamp> now = stamp();
      if (!now.equals(judged)) { // re-read only after a change
        judged = now;
        fault = now.equals(loaded) ? Optional.empty() : Optional.of(judge());
      }
    } finally {
      askedMicros.set(Clock.NEVER);
    }
  }

  private String judge() {
    try {
      reader.apply(file);
      return file
          + ": was changed after it was loaded; the loaded values stay in force until the "
          + "service is restarted";
    } catch (BadInputException e) {
      return e.getMessage() + "; the previously loaded values stay in force";
    }
  }
}
