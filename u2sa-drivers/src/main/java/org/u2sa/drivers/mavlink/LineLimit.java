package org.u2sa.drivers.mavlink;

import java.util.function.Consumer;
import org.u2sa.interfaces.time.Clock;

/**
 * Limits the rate of log lines caused by an autopilot, which controls how often status texts and
 * heartbeats arrive.
 */
final class LineLimit {
  private static final int MAX_LINES = 10; // per second
  private static final long WINDOW_MICROS = Clock.micros(1.0);

  private long windowMicros = Long.MIN_VALUE / 2; // start of the window
  private int lines; // in the window
  private long omitted; // since the last line

  /** Passes a line on, with the number of lines omitted before it, or omits it. */
  void pass(String line, long nowMicros, Consumer<String> to) {
    if (nowMicros - windowMicros >= WINDOW_MICROS || nowMicros < windowMicros) { // set back
      windowMicros = nowMicros;
      lines = 0;
    }
    if (lines == MAX_LINES) {
      omitted++;
      return;
    }
    lines++;
    to.accept(omitted == 0 ? line : line + " (after " + omitted + " lines not logged)");
    omitted = 0;
  }
}
