package org.u2sa.core.communication.limit;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * Rations the network thread's time for clients of the web port that have not logged in: together
 * they get a part of it, in small slices, so that an emergency stop is hardly delayed by them. What
 * is over waits in order of arrival. Confined to the network thread.
 */
public final class WorkQueue {
  private static final double PART = 0.2;
  private static final double PIECE_S = 0.005;

  private final TimeShare time;
  private final Deque<Runnable> waiting = new ArrayDeque<>();

  /** Starts with the full allowance. */
  public WorkQueue(LongSupplier nowMicros) {
    time = new TimeShare(PART, PIECE_S, nowMicros);
  }

  /**
   * Runs work, at once if there is time.
   *
   * @param work must do nothing if its connection has ended
   * @param later runs a task a few milliseconds later on the network thread
   */
  public void run(Runnable work, Consumer<Runnable> later) {
    if (waiting.isEmpty() && time.isOpen()) {
      time.run(work);
      return;
    }
    waiting.add(work);
    if (waiting.size() == 1) {
      later.accept(() -> runWaiting(later));
    }
  }

  private void runWaiting(Consumer<Runnable> later) {
    try {
      while (!waiting.isEmpty() && time.isOpen()) {
        try {
          time.run(waiting.peek());
        } finally {
          waiting.remove(); // afterwards, or work added meanwhile would start a second round
        }
      }
    } finally {
      if (!waiting.isEmpty()) {
        later.accept(() -> runWaiting(later));
      }
    }
  }
}
