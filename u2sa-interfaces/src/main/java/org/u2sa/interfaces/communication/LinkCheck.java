package org.u2sa.interfaces.communication;

import java.io.IOException;
import java.util.function.LongSupplier;

/**
 * Finds dead links of open sessions: nothing came for twice the time of the keep-alive. It asks
 * early, since a broker ends a connection after one and a half times, and a busy machine may hold
 * the question up. Belongs to the thread that reads.
 */
final class LinkCheck {
  private static final int MICROS_PER_MS = 1_000;

  private final LongSupplier clock;
  private final long askAfterMicros;
  private final long giveUpAfterMicros; // of asking
  private long heardMicros;
  private long askedMicros; // 0: nothing

  /**
   * @param clock the time now [µs]
   */
  LinkCheck(LongSupplier clock, long keepAliveMicros) {
    this.clock = clock;
    askAfterMicros = keepAliveMicros / 2;
    giveUpAfterMicros = 2 * keepAliveMicros - askAfterMicros;
    heardMicros = clock.getAsLong();
  }

  /** Takes note that the broker lives. */
  void heard() {
    heardMicros = clock.getAsLong();
    askedMicros = 0;
  }

  /** How long nothing needs to be checked while a session is not open yet. */
  long waitMs() {
    return giveUpAfterMicros / MICROS_PER_MS; // who opens the session waits for the answer
  }

  /**
   * How long nothing needs to be checked.
   *
   * @param sentMicros when something was sent last
   */
  long waitMs(long sentMicros) {
    long dueMicros = askedMicros != 0 ? askedMicros + giveUpAfterMicros : askMicros(sentMicros);
    return Math.max(1, (dueMicros - clock.getAsLong()) / MICROS_PER_MS);
  }

  /**
   * Whether to ask now whether the broker lives.
   *
   * @param sentMicros when something was sent last
   * @throws IOException if it was asked and has not answered
   */
  boolean isToAsk(long sentMicros) throws IOException {
    long now = clock.getAsLong();
    if (askedMicros != 0 && now - askedMicros >= giveUpAfterMicros) {
      throw new IOException("the broker does not answer");
    }
    if (askedMicros != 0 || now < askMicros(sentMicros)) {
      return false;
    }
    askedMicros = now;
    return true;
  }

  private long askMicros(long sentMicros) {
    return Math.min(heardMicros, sentMicros) + askAfterMicros;
  }
}
