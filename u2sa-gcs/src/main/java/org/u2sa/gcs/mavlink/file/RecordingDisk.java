package org.u2sa.gcs.mavlink.file;

import java.io.IOException;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicBoolean;
import org.u2sa.interfaces.disk.DiskThread;

/**
 * Access to recordings for the bridge's thread. It waits half a second at most for a disk that
 * hangs, once, because it also passes on what stations order.
 */
final class RecordingDisk {
  private static final DiskThread DISK = new DiskThread("u2sa-recordings");
  private static final long ANSWERS_WITHIN_MS = 500;

  private final AtomicBoolean isIdle = new AtomicBoolean(true);

  /**
   * The result of an access.
   *
   * @throws IOException if it throws that, or the disk does not answer in time or hangs already
   */
  <T> T answer(Callable<T> access) throws IOException {
    if (!isIdle.compareAndSet(true, false)) {
      throw new IOException("the disk does not answer");
    }
    return DISK.call(
        () -> {
          try {
            return access.call();
          } finally {
            isIdle.set(true);
          }
        },
        ANSWERS_WITHIN_MS);
  }
}
