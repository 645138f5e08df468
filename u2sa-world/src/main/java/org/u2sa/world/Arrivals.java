package org.u2sa.world;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import org.u2sa.messages.schema.U2SAData;

/**
 * What came in and waits until the state of its time is known. The oldest goes when there is too
 * much: a scanner is never worth the vehicle's memory.
 */
final class Arrivals {
  private static final int MOST = 20_000;

  private final Deque<U2SAData> waiting = new ArrayDeque<>();
  private long lost;

  /** Takes a message that has a timestamp. */
  void add(U2SAData message) {
    if (waiting.size() == MOST) {
      waiting.removeFirst();
      lost++;
    }
    waiting.add(message);
  }

  /** Takes out all that was measured up to a time, oldest first; of one time in the order heard. */
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

  /** How many were lost because too many waited. */
  long lost() {
    return lost;
  }
}
