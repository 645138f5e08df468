package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.util.function.LongSupplier;

/**
 * Detects dead links of open sessions: no data for twice the keep-alive interval. Pings early,
 * because a broker disconnects after 1.5 intervals and a busy machine may delay the ping. Confined
 * to the reading thread.
 */
final class LinkCheck {
  private static final int MICROS_PER_MS = 1_000;

  private final LongSupplier clock;
  private final long askAfterMicros;
  private final long giveUpAfterMicros; // after a ping
  private long heardMicros;
  private long askedMicros; // 0 without a pending ping

  /**
   * @param clock current time [µs]
   */
  LinkCheck(LongSupplier clock, long keepAliveMicros) {
    this.clock = clock;
    askAfterMicros = keepAliveMicros / 2;
    giveUpAfterMicros = 2 * keepAliveMicros - askAfterMicros;
    heardMicros = clock.getAsLong();
  }

  void heard() {
    heardMicros = clock.getAsLong();
    askedMicros = 0;
  }

  /** Time until the next check while a session is being opened. */
  long waitMs() {
    return giveUpAfterMicros / MICROS_PER_MS; // the opener waits for the response
  }

  /** Time until the next check; {@code sentMicros} is the time of the last transmission. */
  long waitMs(long sentMicros) {
    long dueMicros = askedMicros != 0 ? askedMicros + giveUpAfterMicros : askMicros(sentMicros);
    return Math.max(1, (dueMicros - clock.getAsLong()) / MICROS_PER_MS);
  }

  /**
   * Whether to ping the broker now.
   *
   * @throws IOException if a ping was not answered
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
