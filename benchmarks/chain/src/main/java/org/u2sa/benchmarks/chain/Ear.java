package org.u2sa.benchmarks.chain;

import java.util.concurrent.atomic.AtomicLong;
import org.HdrHistogram.Histogram;
import org.HdrHistogram.SynchronizedHistogram;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Hears one channel, counts, and times: a message's x is when it was sent [s], 0 if it is not timed. */
final class Ear extends EventDrivenService {
  private final Histogram took = new SynchronizedHistogram(60_000_000_000L, 3);
  private final AtomicLong heard = new AtomicLong();
  private final long periodNanos;

  /** @param periodNanos from one message to the next; 0 if there is none [ns] */
  Ear(ServiceContext context, Channel<StateInformation> channel, long periodNanos) {
    super(context, ServiceRole.OBSERVER, "Ear");
    this.periodNanos = periodNanos;
    subscribe(channel, this::hear);
  }

  private void hear(StateInformation message) {
    long now = System.nanoTime();
    long sent = Math.round(Voice.NANOS_PER_S * message.x().orElse(0.0)); // exact up to 2^53 ns
    if (sent > 0) {
      took.recordValueWithExpectedInterval(Math.max(1, now - sent), periodNanos);
    }
    heard.incrementAndGet();
  }

  long heard() {
    return heard.get();
  }

  Histogram took() {
    return took;
  }
}
