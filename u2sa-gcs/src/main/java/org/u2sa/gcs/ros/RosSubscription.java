package org.u2sa.gcs.ros;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.Future;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;

/**
 * One subscription of a client, with its rate limit. With a queue, messages that come too soon wait
 * for their turn and the oldest beyond its length are dropped; without one, they are dropped.
 * Thread-safe.
 */
final class RosSubscription {
  /** Maximum queue length; longer requests are reduced. */
  static final int LONGEST_QUEUE = 100;

  private static final long MICROS_PER_MS = 1_000L;

  private final RosTopic topic;
  private final long intervalMicros;
  private final int queueLength;
  private final RosBacklog backlog;
  private final Function<Object, String> writer;
  private final Consumer<Supplier<String>> out;
  private final BiFunction<Runnable, Long, Future<?>> later;
  private final Clock clock;
  private final Deque<String> waiting = new ArrayDeque<>(); // guarded by this
  private long next = Long.MIN_VALUE; // earliest time of the next message [µs]; guarded by this
  private boolean ended; // guarded by this
  private Future<?> turn; // task of the oldest waiting message, or null; guarded by this

  /**
   * @param throttleMs minimum time between messages [ms]
   * @param backlog backlog of the client
   * @param writer serializes a message; it waits as text, because its size is then known
   * @param out sends a text, or drops the message without requesting its text
   * @param later runs a task after a time [ms], unless cancelled first
   */
  RosSubscription(
      RosTopic topic,
      long throttleMs,
      long queueLength,
      RosBacklog backlog,
      Function<Object, String> writer,
      Consumer<Supplier<String>> out,
      BiFunction<Runnable, Long, Future<?>> later,
      Clock clock) {
    this.topic = topic;
    intervalMicros = throttleMs * MICROS_PER_MS;
    this.queueLength = (int) Math.min(queueLength, LONGEST_QUEUE);
    this.backlog = backlog;
    this.writer = writer;
    this.out = out;
    this.later = later;
    this.clock = clock;
  }

  RosTopic topic() {
    return topic;
  }

  /** Sends a message, now or later, or drops it. */
  synchronized void offer(Object message) {
    long now = clock.micros();
    if (ended) {
      return;
    }
    if (now >= next && waiting.isEmpty()) {
      next = now + intervalMicros;
      out.accept(() -> writer.apply(message));
    } else if (queueLength > 0) {
      queue(writer.apply(message));
      if (turn == null && !waiting.isEmpty()) {
        await(now);
      }
    }
  }

  private void queue(String text) {
    if (waiting.size() == queueLength) {
      remove();
    }
    boolean isHeld = backlog.hold(text.length());
    while (!isHeld && !waiting.isEmpty()) {
      remove();
      isHeld = backlog.hold(text.length());
    }
    if (isHeld) {
      waiting.add(text);
    }
  }

  private String remove() {
    String oldest = waiting.remove();
    backlog.free(oldest.length());
    return oldest;
  }

  private void await(long now) {
    turn =
        later.apply(this::release, Math.max(1, (next - now + MICROS_PER_MS - 1) / MICROS_PER_MS));
  }

  private synchronized void release() {
    turn = null;
    if (ended || waiting.isEmpty()) {
      return;
    }
    long now = clock.micros();
    if (now >= next) {
      next = now + intervalMicros;
      String oldest = remove();
      out.accept(() -> oldest);
    }
    if (!waiting.isEmpty()) {
      await(now);
    }
  }

  /** Ends it now: a task that waits for its turn, up to an hour, would keep it in memory. */
  synchronized void end() {
    ended = true;
    while (!waiting.isEmpty()) {
      remove();
    }
    if (turn != null) {
      turn.cancel(false);
    }
  }
}
