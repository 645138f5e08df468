package org.u2sa.world;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import org.u2sa.messages.schema.U2SAData;

/**
 * Bounded queue of measurements waiting for the vehicle state of their time. Drops the oldest when
 * full, so that a fast scanner cannot exhaust the memory.
 */
final class Arrivals {
  private static final int MOST = 20_000;

  private final Deque<U2SAData> waiting = new ArrayDeque<>();
  private long lost;

  /** Queues a message, which must have a timestamp. */
  void add(U2SAData message) {
    if (waiting.size() == MOST) {
      waiting.removeFirst();
      lost++;
    }
    waiting.add(message);
  }

  /** Removes all messages measured up to a time, oldest first; equal times in order of arrival. */
  List<U2SAData> upTo(long micros) {
    List<U2SAData> due = new ArrayList<>();
    waiting.removeIf(
        message -> {
          boolean isDue = message.timestamp().orElseThrow() <= micros;
          if (isDue) {
            due.add(message);
          }
          return isDue;
        });
    due.sort(Comparator.comparingLong(message -> message.timestamp().orElseThrow())); // stable
    return due;
  }

  /** Number of messages dropped because the queue was full. */
  long lost() {
    return lost;
  }
}
