package org.u2sa.trials.run;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.u2sa.interfaces.RunFailedException;

/**
 * Handles Ctrl-C or SIGTERM during a run: the run shuts down cleanly with neutral actuators and
 * writes its report before the JVM exits. The exit code is the system's, 130 or 143.
 */
public final class Interruption implements AutoCloseable {
  private static final long END_WITHIN_S = 15;

  private final CountDownLatch ended = new CountDownLatch(1);
  private final Thread running = Thread.currentThread();
  private final Thread hook = new Thread(this::endRun, "u2sa-interruption");
  private final AtomicReference<Runnable> onRequest = new AtomicReference<>(() -> {});
  private volatile boolean asked;
  private volatile boolean waitingForOthers;

  /** Starts watching for the signal. */
  public Interruption() {
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /** Whether termination was requested. */
  boolean isAsked() {
    return asked;
  }

  /** A task that may take minutes and can only be cancelled by interrupting its thread. */
  @FunctionalInterface
  interface LongWait {
    void begin() throws InterruptedException;
  }

  /**
   * Runs the task on the calling thread, cancelling it when termination is requested.
   *
   * @throws RunFailedException if it was cancelled
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

  /** Registers an action to run on another thread when termination is requested. */
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
      Thread.currentThread().interrupt(); // the JVM exits immediately
    }
  }

  /** Stops watching: shutdown is complete, and the JVM may exit. */
  @Override
  public void close() {
    ended.countDown();
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // The JVM is already exiting, and the hook has run.
      return;
    }
  }
}
