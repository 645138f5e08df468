package org.u2sa.gcs.remote;

import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.schema.U2SAData;

/**
 * Messages of channels, waiting to be shown: a slow terminal holds nobody up. What finds no room is
 * dropped and counted.
 */
public final class MessageStream {
  private static final int ROOM = 4096;

  /** A message, where it came from, and when [µs of real time]. */
  public record Heard(Channel<?> channel, U2SAData message, long micros) {}

  private final BlockingQueue<Heard> waiting = new ArrayBlockingQueue<>(ROOM);
  private final AtomicLong dropped = new AtomicLong();
  private final RemoteLink link;

  /** Over that link. */
  public MessageStream(RemoteLink link) {
    this.link = link;
  }

  /** Takes the messages of that channel, too. */
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

  /** The next one; empty if none comes in that time. */
  public Optional<Heard> next(long millis) throws InterruptedException {
    return Optional.ofNullable(waiting.poll(millis, TimeUnit.MILLISECONDS));
  }

  /** Messages that found no room. */
  public long dropped() {
    return dropped.get();
  }
}
