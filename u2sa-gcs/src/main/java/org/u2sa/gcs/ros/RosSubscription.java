package org.u2sa.gcs.ros;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.u2sa.interfaces.time.Clock;

/**
 * One subscription of a client, with its rate limit. With a queue, messages that come too soon wait
 * for their turn and the oldest beyond its length are dropped; without one, they are dropped.
 * Thread-safe.
 */
final class RosSubscription {
  /** Longest queue; a longer one is shortened. */
  static final int LONGEST_QUEUE = 100;

  private static final long MICROS_PER_MS = 1_000L;

  private final RosTopic topic;
  private final RosSpelling spelling;
  private final long intervalMicros;
  private final int queueLength;
  private final Consumer<Object> out;
  private final BiConsumer<Runnable, Long> later;
  private final Clock clock;
  private final Deque<Object> waiting = new ArrayDeque<>(); // guarded by this
  private long next = Long.MIN_VALUE; // earliest time of the next message [µs]; guarded by this
  private boolean ended; // guarded by this

  /**
   * @param throttleMs least time between messages [ms]
   * @param out sends a message
   * @param later runs a task after a time [ms]
   */
  RosSubscription(
      RosTopic topic,
      RosSpelling spelling,
      long throttleMs,
      long queueLength,
      Consumer<Object> out,
      BiConsumer<Runnable, Long> later,
      Clock clock) {
    this.topic = topic;
    this.spelling = spelling;
    intervalMicros = throttleMs * MICROS_PER_MS;
    this.queueLength = (int) Math.min(queueLength, LONGEST_QUEUE);
    this.out = out;
    this.later = later;
    this.clock = clock;
  }

  RosTopic topic() {
    return topic;
  }

  RosSpelling spelling() {
    return spelling;
  }

  /** Sends a message, now or later, or drops it. */
  synchronized void offer(Object message) {
    long now = clock.micros();
    if (now >= next && waiting.isEmpty()) {
      next = now + intervalMicros;
      out.accept(message);
    } else if (queueLength > 0) {
      waiting.add(message);
      if (waiting.size() == 1) {
        await(now);
      } else if (waiting.size() > queueLength) {
        waiting.remove();
      }
    }
  }

  private void await(long now) {
    later.accept(this::release, Math.max(1, (next - now + MICROS_PER_MS - 1) / MICROS_PER_MS));
  }

  private synchronized void release() {
    if (ended || waiting.isEmpty()) {
      return;
    }
    long now = clock.micros();
    if (now >= next) {
      next = now + intervalMicros;
      out.accept(waiting.remove());
    }
    if (!waiting.isEmpty()) {
      await(now);
    }
  }

  synchronized void end() {
    ended = true;
    waiting.clear();
  }
}
