package org.u2sa.drivers.ioio;

import ioio.lib.api.IOIO;
import ioio.lib.api.exception.ConnectionLostException;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Queries a connected board on a daemon thread: a board that sends data but accepts none drives its
 * pins by old commands even in an emergency stop, and only its answers reveal this.
 */
final class BoardEcho {
  private final IOIO ioio;
  private final long everyMs;
  private final AtomicLong answers = new AtomicLong();
  private boolean hurry; // guarded by this
  private final Thread thread = new Thread(this::ask, "u2sa-ioio-echo");

  /**
   * Idle until {@link #start}.
   *
   * @param everyMs pause between an answer and the next query
   */
  BoardEcho(IOIO ioio, long everyMs) {
    this.ioio = ioio;
    this.everyMs = everyMs;
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  /** Number of answers so far. */
  long answers() {
    return answers.get();
  }

  private void ask() {
    try {
      while (!Thread.currentThread().isInterrupted()) {
        ioio.sync();
        answers.incrementAndGet();
        pause();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ConnectionLostException | IllegalStateException e) {
      return; // ended
    }
  }

  private synchronized void pause() throws InterruptedException {
    if (!hurry) {
      wait(everyMs);
    }
    hurry = false;
  }

  /** Sends the next query without the preceding pause. */
  synchronized void askNow() {
    hurry = true;
    notifyAll();
  }

  /** Ends the thread and waits for its end; has no effect if it has ended or was never started. */
  void end() {
    thread.interrupt();
    boolean wasInterrupted = false;
    while (thread.isAlive()) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        wasInterrupted = true;
      }
    }
    if (wasInterrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
