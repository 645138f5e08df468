package org.u2sa.scenarios.run;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.u2sa.gcs.command.RunFailedException;

/**
 * Ctrl-C or TERM during a run: the run ends in good order, actuators neutral, and its report is
 * written, before the virtual machine does. Its exit code is the system's, 130 or 143.
 */
public final class Interruption implements AutoCloseable {
  private static final long END_WITHIN_S = 15;

  private final CountDownLatch ended = new CountDownLatch(1);
  private final Thread running = Thread.currentThread();
  private final Thread hook = new Thread(this::endRun, "u2sa-interruption");
  private final AtomicReference<Runnable> onRequest = new AtomicReference<>(() -> {});
  private volatile boolean asked;
  private volatile boolean waitingForOthers;

  /** Watches from now on. */
  public Interruption() {
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /** Whether the program was told to end. */
  boolean isAsked() {
    return asked;
  }

  /** Something that may take minutes and can be broken off only by interrupting its thread. */
  @FunctionalInterface
  interface LongWait {
    void begin() throws InterruptedException;
  }

  /**
   * Does it, on this thread, and breaks it off when the program is told to end.
   *
   * @throws RunFailedException if it was broken off
   */
  void breakingOff(LongWait wait) throws InterruptedException {
    waitingForOthers = true;
    try {
      if (!asked) {
        wait.begin();
      }
    } catch (InterruptedException e) {
      if (asked) {
        throw new RunFailedException("interrupted before the run began", e);
      }
      throw e;
    } finally {
      waitingForOthers = false;
    }
  }

  /** Does this, on another thread, when the program is told to end. */
  public void onRequest(Runnable action) {
    onRequest.set(action);
    if (asked) {
      action.run();
    }
  }

  private void endRun() {
    asked = true;
    onRequest.get().run();
    if (waitingForOthers) {
      running.interrupt();
    }
    try {
      ended.await(END_WITHIN_S, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // the virtual machine ends at once
    }
  }

  /** Ends the watch: all is in order, and the virtual machine may end. */
  @Override
  public void close() {
    ended.countDown();
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // The virtual machine is ending, which is what the hook was for.
      return;
    }
  }
}
