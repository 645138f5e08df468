package org.u2sa.service.directory;

import java.util.Locale;
import java.util.function.Consumer;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.DiscoveryResponse;

/**
 * Measures the offset between this process's clock and that of the services already running, using
 * one request and the timestamps of its answers (as in NTP, RFC 5905, section 8): an answer was
 * stamped between the request and its own arrival. Of answers that agree with each other the
 * fastest counts; of others the one nearest to this process's clock, so that a liar among them can
 * not set it. Thread-safe.
 */
public final class ClockAgreement {
  /** Smaller offsets are not corrected [µs]. */
  private static final long TOLERATED_MICROS = 100_000;

  private static final long SAME_MICROS = 100_000; // apart, of honest answers

  private static final long OTHERS_MICROS = 200_000; // after the first answer

  /** 2001-09-09 [µs]: an earlier time is simulated time, which a real clock cannot follow. */
  private static final long REAL_SINCE_MICROS = 1_000_000_000_000_000L;

  private static final long REAL_UNTIL_MICROS = 4_102_444_800_000_000L; // 2100-01-01

  private long askedMicros;
  private String source = ""; // service with the fastest answer
  private long aheadMicros;
  private long errorMicros;
  private long heardMicros; // when the first answer arrived

  public ClockAgreement(long nowMicros) {
    askedMicros = nowMicros;
  }

  /** Call immediately before the request is sent. */
  public synchronized void asked(long nowMicros) {
    askedMicros = nowMicros;
  }

  public synchronized void hear(DiscoveryResponse answer, long nowMicros) {
    long saidMicros = answer.timestamp().orElse(0L);
    long error = (nowMicros - askedMicros) / 2;
    long ahead = saidMicros - (askedMicros + error);
    boolean isSame = Math.abs(ahead - aheadMicros) <= SAME_MICROS + error + errorMicros;
    boolean isBetter = isSame ? error < errorMicros : Math.abs(ahead) < Math.abs(aheadMicros);
    boolean isReal = saidMicros > REAL_SINCE_MICROS && saidMicros < REAL_UNTIL_MICROS;
    if (isReal && (source.isEmpty() || isBetter)) {
      heardMicros = source.isEmpty() ? nowMicros : heardMicros;
      source = answer.serviceName() + " on " + answer.host();
      errorMicros = error;
      aheadMicros = ahead;
    }
  }

  /** Whether an answer arrived. */
  public synchronized boolean isHeard() {
    return !source.isEmpty();
  }

  /**
   * Whether waiting is over: an answer agrees with this process's clock, so that no other can be
   * better, or the others have had twice as long as the first one took.
   */
  public synchronized boolean isReached(long nowMicros) {
    long patience = Math.max(OTHERS_MICROS, 2 * (heardMicros - askedMicros));
    boolean isAgreed = Math.abs(aheadMicros) <= TOLERATED_MICROS + errorMicros;
    return !source.isEmpty() && (isAgreed || nowMicros - heardMicros > patience);
  }

  /**
   * Lead of the others' clock [µs]; 0 if it agrees within the accuracy or no service answered.
   *
   * @param log receives a message if the clocks disagree
   */
  public synchronized long aheadMicros(Consumer<String> log) {
    if (Math.abs(aheadMicros) <= TOLERATED_MICROS + (source.isEmpty() ? 0L : errorMicros)) {
      return 0L;
    }
    log.accept(
        String.format(
            Locale.ROOT,
            "this machine's clock is %.3f s %s the clock of %s (± %.3f s): follows the system's "
                + "time",
            Clock.seconds(Math.abs(aheadMicros)),
            aheadMicros > 0 ? "behind" : "ahead of",
            source,
            Clock.seconds(errorMicros)));
    return aheadMicros;
  }
}
