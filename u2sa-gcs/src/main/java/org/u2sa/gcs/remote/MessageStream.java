package org.u2sa.gcs.remote;

import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.schema.U2SAData;

/**
 * Queue of received messages waiting to be shown, so that a slow terminal does not block senders.
 * Overflow is dropped and counted.
 */
public final class MessageStream {
  private static final int ROOM = 4096;

  /** A message with its channel and arrival time [µs of real time]. */
  public record Heard(Channel<?> channel, U2SAData message, long micros) {}

  private final BlockingQueue<Heard> waiting = new ArrayBlockingQueue<>(ROOM);
  private final AtomicLong dropped = new AtomicLong();
  private final RemoteLink link;

  public MessageStream(RemoteLink link) {
    this.link = link;
  }

  /** Adds a channel. */
  public MessageStream of(Channel<?> channel) {
    link.listen(
        channel,
        message -> {
          if (!waiting.offer(new Heard(channel, message, link.clock().micros()))) {
            dropped.incrementAndGet();
          }
        });
    return this;
  }

  /** Next message; empty if none arrives in time. */
  public Optional<Heard> next(long millis) throws InterruptedException {
    return Optional.ofNullable(waiting.poll(millis, TimeUnit.MILLISECONDS));
  }

  /** Number of messages dropped. */
  public long dropped() {
    return dropped.get();
  }
}
