package org.u2sa.core.communication;

import io.netty.channel.Channel;
import io.netty.channel.ChannelPipeline;
import io.netty.handler.ssl.SslContext;
import io.netty.handler.ssl.SslHandler;
import java.util.concurrent.PriorityBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;

/**
 * TLS of the broker's connections. Handshakes are computed on a separate thread (key exchange and
 * signature take milliseconds), so that the network thread keeps serving others. Networks with a
 * successful login have priority.
 */
final class Encryption implements AutoCloseable {
  private final SslContext context;
  private final AtomicLong sofar = new AtomicLong();
  private final ThreadPoolExecutor handshakes =
      new ThreadPoolExecutor(
          1, 1, 0, TimeUnit.SECONDS, new PriorityBlockingQueue<>(), Encryption::thread);

  Encryption(SslContext context) {
    this.context = context;
  }

  private static Thread thread(Runnable steps) {
    Thread thread = new Thread(steps, "u2sa-tls-handshakes");
    thread.setDaemon(true);
    return thread;
  }

  /**
   * Inserts encryption before a connection's other handlers.
   *
   * @param isKnown whether the client's network has had a successful login
   */
  void addTo(ChannelPipeline pipeline, TlsRecords records, boolean isKnown) {
    Channel channel = pipeline.channel();
    SslHandler tls =
        new SslHandler(
            context.newEngine(channel.alloc()),
            step -> handshakes.execute(new Step(channel, step, isKnown, sofar.incrementAndGet())));
    pipeline.addFirst(records, tls, records.behind());
  }

  /**
   * A handshake computation. Bounded by the number of accepted connections, each of which waits for
   * at most one.
   */
  private record Step(Channel channel, Runnable computation, boolean isKnown, long number)
      implements Runnable, Comparable<Step> {
    @Override
    public void run() {
      if (channel.isActive()) { // otherwise displaced by a newer connection
        computation.run();
      }
    }

    @Override
    public int compareTo(Step other) {
      return isKnown == other.isKnown ? Long.compare(number, other.number) : isKnown ? -1 : 1;
    }
  }

  @Override
  public void close() {
    handshakes.shutdownNow();
  }
}
