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
 * TLS of the broker's connections. A thread of its own computes their handshakes (key exchange and
 * signature take milliseconds), so that the network thread serves the others meanwhile. Those from
 * networks from which somebody has logged in go first.
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
   * Puts encryption before a connection's other handlers.
   *
   * @param isKnown whether somebody has logged in from the client's network
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
   * One computation of a handshake. Their number is bounded by that of the accepted connections,
   * each of which waits for one at most.
   */
  private record Step(Channel channel, Runnable computation, boolean isKnown, long number)
      implements Runnable, Comparable<Step> {
    @Override
    public void run() {
      if (channel.isActive()) { // else it was put out for a newer one
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
