package org.u2sa.trials.board;

import java.util.function.Consumer;
import org.u2sa.interfaces.time.Clock;

/** Limits log lines, so that hosts that reconnect rapidly cannot flood the log. Thread-safe. */
final class PacedLog implements Consumer<String> {
  private static final int AT_ONCE = 20;
  private static final long MICROS_A_LINE = Clock.MICROS_PER_SECOND;

  private final Clock clock;
  private final Consumer<String> lines;
  private long spentMicros; // time up to which the allowance has been used
  private int left; // lines omitted since the last one

  PacedLog(Clock clock, Consumer<String> lines) {
    this.clock = clock;
    this.lines = lines;
  }

  @Override
  public synchronized void accept(String line) {
    long now = clock.micros();
    spentMicros = Math.max(spentMicros, now - AT_ONCE * MICROS_A_LINE);
    if (spentMicros + MICROS_A_LINE > now) {
      left++;
      return;
    }
    spentMicros += MICROS_A_LINE;
    lines.accept(left == 0 ? line : line + " (" + left + " lines omitted before)");
    left = 0;
  }
}
