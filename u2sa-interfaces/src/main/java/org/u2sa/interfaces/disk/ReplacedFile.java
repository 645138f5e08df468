package org.u2sa.interfaces.disk;

import java.io.IOException;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.u2sa.interfaces.time.Clock;

/**
 * A file that is replaced atomically. In real time the {@link DiskThread} writes it, and only the
 * last of several pending changes; in simulated time the caller writes it.
 */
public final class ReplacedFile {
  private static final long READS_WITHIN_MS = 5_000;

  private final boolean atOnce;
  private final AtomicReference<Change> waiting = new AtomicReference<>();

  public interface Change {
    void make() throws IOException;
  }

  public ReplacedFile(Clock clock) {
    atOnce = clock.isSimulated();
  }

  /**
   * Schedules the change, replacing a pending one.
   *
   * @param failed called if it fails, possibly later on another thread
   */
  public void change(Change change, Consumer<IOException> failed) {
    if (atOnce) {
      make(change, failed);
    } else if (waiting.getAndSet(change) == null) {
      DiskThread.ofProcess().execute(() -> make(waiting.getAndSet(null), failed));
    }
  }

  private static void make(Change change, Consumer<IOException> failed) {
    try {
      change.make();
    } catch (IOException e) {
      failed.accept(e);
    }
  }

  /**
   * Reads the file after all requested changes.
   *
   * @throws IOException if reading throws it, or the disk does not answer within 5 s
   */
  public <T> T read(Callable<T> reading) throws IOException {
    return atOnce ? now(reading) : DiskThread.ofProcess().call(reading, READS_WITHIN_MS);
  }

  private static <T> T now(Callable<T> reading) throws IOException {
    try {
      return reading.call();
    } catch (IOException | RuntimeException e) {
      throw e;
    } catch (Exception e) {
      throw new IOException(e);
    }
  }
}
