package org.u2sa.world;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import org.u2sa.messages.schema.U2SAData;

/**
 * Bounded queue of measurements waiting for the vehicle state of their time. Drops the oldest when
 * full, so that a fast scanner or an oversized scan cannot exhaust memory.
 */
final class Arrivals {
  private static final int MAX_WAITING = 20_000;

  /** Memory for messages from other processes. */
  private static final long MAX_BYTES = Math.max(4L << 20, Runtime.getRuntime().maxMemory() / 32);

  private final Deque<U2SAData> waiting = new ArrayDeque<>();
  private long bytes; // size of those from other processes
  private long lost;

  /** Queues a message, which must have a timestamp. */
  void add(U2SAData message) {
    waiting.add(message);
    bytes += message.receivedBytes();
    while (waiting.size() > MAX_WAITING || bytes > MAX_BYTES) {
      bytes -= waiting.removeFirst().receivedBytes();
      lost++;
    }
  }

  /** Removes all messages measured up to a time, oldest first; equal times in order of arrival. */
  List<U2SAData> upTo(long micros) {
    List<U2SAData> due = new ArrayList<>();
    waiting.removeIf(
        message -> {
          boolean isDue = message.timestamp().orElseThrow() <= micros;
          if (isDue) {
            due.add(message);
            bytes -= message.receivedBytes();
          }
          return isDue;
        });
    due.sort(Comparator.comparingLong(message -> message.timestamp().orElseThrow())); // stable
    return due;
  }

  long lost() {
    return lost;
  }
}
