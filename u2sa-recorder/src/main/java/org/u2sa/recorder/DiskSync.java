package org.u2sa.recorder;

import java.io.IOException;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.FileChannel;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * Syncs a file to disk so that a power cut does not lose it. Runs on its own thread: a busy disk
 * may take seconds, during which writing must continue.
 */
final class DiskSync implements AutoCloseable {
  private static final long LOOK_UP_EVERY_MS = 100; // polls for the end

  private final BlockingQueue<FileChannel> asked = new ArrayBlockingQueue<>(1);
  private final Consumer<String> trouble;
  private final Thread thread = new Thread(this::run, "u2sa-recorder-sync");
  private volatile boolean closing;
  private String said = ""; // last reported failure; used by the thread only

  DiskSync(Consumer<String> trouble) {
    this.trouble = trouble;
    thread.setDaemon(true);
    thread.start();
  }

  /** Requests a sync; covered by a pending request that has not started yet. */
  void ask(FileChannel file) {
    asked.offer(file);
  }

  private void run() {
    try {
      while (!closing) {
        FileChannel file = asked.poll(LOOK_UP_EVERY_MS, TimeUnit.MILLISECONDS);
        if (file != null) {
          force(file);
        }
      }
    } catch (InterruptedException e) {
      trouble.accept("interrupted: a power cut may lose the recording's last seconds");
    }
  }

  private void force(FileChannel file) {
    try {
      file.force(false);
    } catch (ClosedChannelException e) {
      return; // closed in the meantime: the system flushes it
    } catch (IOException | RuntimeException e) { // the next sync may succeed
      String what = "the recording cannot be synced to the disk: " + e.getMessage();
      if (!what.equals(said)) { // otherwise four times a second
        said = what;
        trouble.accept(what);
      }
    }
  }

  @Override
  public void close() {
    closing = true;
  }
}
