package org.u2sa.recorder;

import java.io.IOException;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.FileChannel;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * Has the disk keep what was written to a file, so that a power cut does not lose it. On a thread
 * of its own: a busy disk may take seconds, in which messages are to be written on.
 */
final class DiskSync implements AutoCloseable {
  private static final long LOOK_UP_EVERY_MS = 100; // for the end

  private final BlockingQueue<FileChannel> asked = new ArrayBlockingQueue<>(1);
  private final Consumer<String> trouble;
  private final Thread thread = new Thread(this::run, "u2sa-recorder-sync");
  private volatile boolean closing;
  private String said = ""; // by the thread

  /**
   * @param trouble told if the disk refuses
   */
  DiskSync(Consumer<String> trouble) {
    this.trouble = trouble;
    thread.setDaemon(true);
    thread.start();
  }

  /** Asks for it; a file that was asked for and not begun yet is enough for both. */
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
      return; // the file was ended meanwhile: the system writes it out by itself
    } catch (IOException | RuntimeException e) { // the next one may work
      String what = "the disk does not keep what is recorded: " + e.getMessage();
      if (!what.equals(said)) { // four times a second otherwise
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
