package org.u2sa.core.launch;

import java.util.Locale;
import java.util.function.Consumer;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.DiscoveryResponse;

/**
 * How far this process's clock is from that of the services that run already, by one question and
 * the timestamps of its answers (as NTP does, RFC 5905, section 8): an answer was stamped between
 * the question and its arrival. The answer that came soonest counts. Safe for several threads.
 */
final class ClockAgreement {
  /** Clocks that are nearer to each other than this are left as they are [µs]. */
  private static final long TOLERATED_MICROS = 100_000;

  /** 2001-09-09: who says an earlier time runs in simulated time, which nobody can follow [µs]. */
  private static final long REAL_SINCE_MICROS = 1_000_000_000_000_000L;

  private long askedMicros;
  private String source = ""; // whose answer counts
  private long aheadMicros;
  private long errorMicros = Clock.NEVER;

  ClockAgreement(long nowMicros) {
    askedMicros = nowMicros;
  }

  /** Takes note of when the question left. */
  synchronized void asked(long nowMicros) {
    askedMicros = nowMicros;
  }

  /** Takes note of an answer. */
  synchronized void hear(DiscoveryResponse answer, long nowMicros) {
    long saidMicros = answer.timestamp().orElse(0L);
    long error = (nowMicros - askedMicros) / 2;
    if (saidMicros > REAL_SINCE_MICROS && error < errorMicros) {
      source = answer.serviceName() + " on " + answer.host();
      errorMicros = error;
      aheadMicros = saidMicros - (askedMicros + error);
    }
  }

  /**
   * By how much the others are ahead [µs]; 0 if they agree as far as can be told, or none answered.
   *
   * @param log told if they do not agree
   */
  synchronized long aheadMicros(Consumer<String> log) {
    if (Math.abs(aheadMicros) <= TOLERATED_MICROS + (source.isEmpty() ? 0L : errorMicros)) {
      return 0L;
    }
    log.accept(
        String.format(
            Locale.ROOT,
            "this machine's clock is %.3f s %s that of %s (± %.3f s): goes by the system's time",
            Clock.seconds(Math.abs(aheadMicros)),
            aheadMicros > 0 ? "behind" : "ahead of",
            source,
            Clock.seconds(errorMicros)));
    return aheadMicros;
  }
}
