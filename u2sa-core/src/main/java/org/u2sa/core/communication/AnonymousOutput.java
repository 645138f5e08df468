package org.u2sa.core.communication;

import io.netty.util.concurrent.EventExecutor;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.u2sa.core.communication.limit.TimeShare;
import org.u2sa.core.communication.routing.Publication;

/**
 * Messages to the clients that have no log-in, where others have one. Together they get a part of
 * the network thread's time, so that however many listen, messages between the others are hardly
 * delayed. What is over waits; beyond the limits the oldest messages are dropped and counted, so
 * that the newest arrive. Confined to the network thread.
 */
final class AnonymousOutput {
  /** A client without a log-in. */
  interface Recipient {
    /** Name for the log. */
    String label();

    /** Sends a message, unless the client has left. */
    boolean deliverNow(Publication publication, boolean eachMatters);
  }

  private record Waiting(Recipient to, Publication publication, boolean eachMatters, int bytes) {}

  static final int MAX_WAITING = 16_384; // messages, each counted for each recipient
  private static final int LOOK_AGAIN_MS = 2;
  private static final long MAX_BYTES = Runtime.getRuntime().maxMemory() / 32;
  private static final int BYTES_OF_ONE = 128; // memory of one that waits, without its payload

  private final TimeShare time;
  private final Consumer<String> dropped;
  private final Deque<Waiting> waiting = new ArrayDeque<>();
  private long bytes; // of those that wait
  private boolean isScheduled;

  /**
   * @param dropped receives the client of each message that is dropped
   */
  AnonymousOutput(TimeShare time, Consumer<String> dropped) {
    this.time = time;
    this.dropped = dropped;
  }

  /** Time of these clients; sockets' writes are charged to it too. */
  TimeShare time() {
    return time;
  }

  /**
   * Sends a message, at once if there is time and no other waits.
   *
   * @param network the network thread
   */
  void add(Recipient to, Publication publication, boolean eachMatters, EventExecutor network) {
    if (waiting.isEmpty() && time.isOpen()) {
      time.run(() -> to.deliverNow(publication, eachMatters));
      return;
    }
    Publication kept = publication.lasting();
    int length = BYTES_OF_ONE + kept.length();
    waiting.add(new Waiting(to, kept, eachMatters, length));
    bytes += length;
    while (waiting.size() > MAX_WAITING || bytes > MAX_BYTES) {
      dropped.accept(next().to.label());
    }
    sendLater(network);
  }

  private Waiting next() {
    Waiting next = waiting.remove();
    bytes -= next.bytes;
    return next;
  }

  private void sendLater(EventExecutor network) {
    if (!isScheduled && !waiting.isEmpty()) {
      isScheduled = true;
      network.schedule(() -> sendWaiting(network), LOOK_AGAIN_MS, TimeUnit.MILLISECONDS);
    }
  }

  private void sendWaiting(EventExecutor network) {
    isScheduled = false;
    try {
      while (!waiting.isEmpty() && time.isOpen()) {
        Waiting one = next();
        time.run(() -> one.to.deliverNow(one.publication, one.eachMatters));
        one.publication.release();
      }
    } finally {
      sendLater(network);
    }
  }
}
