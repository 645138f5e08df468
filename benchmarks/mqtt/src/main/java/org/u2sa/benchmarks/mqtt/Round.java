package org.u2sa.benchmarks.mqtt;

import java.nio.ByteBuffer;
import java.util.Base64;
import java.util.concurrent.locks.LockSupport;
import org.HdrHistogram.Histogram;

/** Measures one open way: paced, or as fast as it goes with a limited number on the way. */
final class Round {
  private static final long BYTES_ON_THE_WAY_AT_MOST = 2 << 20;
  private static final int SENT_AT_ONCE = 16; // between looks at what has arrived
  private static final long LOST_AFTER_NANOS = 3_000_000_000L;
  private static final double NANOS_PER_MICRO = 1e3;
  private static final double NANOS_PER_S = 1e9;
  private static final double P99 = 99.0;
  private static final double P999 = 99.9;

  /** Whom orders to listen go to: of this process or another. */
  @FunctionalInterface
  interface Orders {
    String obey(String order) throws Exception;
  }

  private final Way way;
  private final Orders listener;
  private final Progress progress;
  private final Brokers brokers;
  private final boolean twoProcesses;
  private final int onTheWayAtMost;

  /**
   * @param onTheWayAtMost messages on the way, when as many are sent as arrive; 0: any number
   */
  Round(
      Way way,
      Orders listener,
      Progress progress,
      Brokers brokers,
      boolean twoProcesses,
      int onTheWayAtMost) {
    this.onTheWayAtMost = onTheWayAtMost;
    this.way = way;
    this.listener = listener;
    this.progress = progress;
    this.brokers = brokers;
    this.twoProcesses = twoProcesses;
  }

  Result measure(String name, Ways.Load load, int perS, int round, double seconds)
      throws Exception {
    listener.obey("begin");
    Listener.Usage before = Listener.Usage.now();
    long brokerBefore = brokers.mosquittoCpuNanos();
    long began = System.nanoTime();
    long sent =
        perS == 0 ? flatOut(load, began, seconds) : paced(perS, began, Math.max(1, seconds));
    await(sent);
    double tookS = (System.nanoTime() - began) / NANOS_PER_S;
    long arrived = progress.count();
    String[] report = listener.obey("report").split(" ");
    Histogram took =
        Histogram.decodeFromByteBuffer(ByteBuffer.wrap(Base64.getDecoder().decode(report[0])), 0);
    Listener.Usage used = Listener.Usage.now().since(before);
    if (twoProcesses) {
      used = used.and(new Listener.Usage(Long.parseLong(report[1]), Long.parseLong(report[2])));
    }
    long cpuNanos = used.cpuNanos() + brokers.mosquittoCpuNanos() - brokerBefore;
    return new Result(
        name,
        twoProcesses,
        load.bytes(),
        load.quality(),
        perS,
        round,
        took.getValueAtPercentile(50) / NANOS_PER_MICRO,
        took.getValueAtPercentile(P99) / NANOS_PER_MICRO,
        took.getValueAtPercentile(P999) / NANOS_PER_MICRO,
        arrived / tookS,
        sent - arrived,
        cpuNanos / NANOS_PER_MICRO / sent,
        (double) used.allocatedBytes() / sent);
  }

  /** Sends at a rate; a message is timed from just before it is sent. */
  private long paced(int perS, long began, double seconds) throws Exception {
    long count = (long) (perS * seconds);
    for (long i = 0; i < count; i++) {
      long due = began + (long) (i * NANOS_PER_S / perS);
      for (long now = System.nanoTime(); now < due; now = System.nanoTime()) {
        LockSupport.parkNanos(due - now);
      }
      way.send(System.nanoTime());
    }
    return count;
  }

  /** Sends without pause, but what is measured is not to be a queue. */
  private long flatOut(Ways.Load load, long began, double seconds) throws Exception {
    long window =
        onTheWayAtMost == 0
            ? Long.MAX_VALUE
            : Math.min(onTheWayAtMost, BYTES_ON_THE_WAY_AT_MOST / load.bytes());
    long end = began + (long) (seconds * NANOS_PER_S);
    long sent = 0;
    long progressed = began;
    while (System.nanoTime() < end) {
      long seen = progress.count();
      while (sent - progress.count() > window - SENT_AT_ONCE) {
        LockSupport.parkNanos(1_000);
        if (progress.count() != seen) {
          seen = progress.count();
          progressed = System.nanoTime();
        } else if (System.nanoTime() - progressed > LOST_AFTER_NANOS) {
          return sent;
        }
      }
      for (int i = 0; i < SENT_AT_ONCE; i++) {
        way.send(System.nanoTime());
        sent++;
      }
      progressed = System.nanoTime();
    }
    return sent;
  }

  private void await(long sent) {
    long seen = progress.count();
    long progressed = System.nanoTime();
    while (progress.count() < sent && System.nanoTime() - progressed < LOST_AFTER_NANOS) {
      LockSupport.parkNanos(100_000);
      if (progress.count() != seen) {
        seen = progress.count();
        progressed = System.nanoTime();
      }
    }
  }
}
