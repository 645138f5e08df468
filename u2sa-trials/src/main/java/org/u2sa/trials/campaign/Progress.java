package org.u2sa.trials.campaign;

import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.u2sa.cli.terminal.Terminal;

/** Displays the progress of a campaign: a bar redrawn in place, or periodic lines. */
final class Progress {
  private static final int BAR_WIDTH = 24;
  private static final long LINE_EVERY_US = TimeUnit.SECONDS.toMicros(10);
  private static final String CLEAR_TO_END_OF_LINE = "\u001b[K";

  private final Terminal terminal;
  private final LongSupplier nowMicros;
  private final int runs;
  private final int before;
  private final long startMicros;
  private long shownMicros;
  private int done;
  private int failed;

  /**
   * @param runs number of runs of the campaign
   * @param before number of runs completed earlier
   */
  Progress(Terminal terminal, LongSupplier nowMicros, int runs, int before) {
    this.terminal = terminal;
    this.nowMicros = nowMicros;
    this.runs = runs;
    this.before = before;
    done = before;
    startMicros = nowMicros.getAsLong();
    shownMicros = startMicros;
  }

  /** Counts a completed run. */
  void done(Outcome outcome) {
    done++;
    failed += outcome.success() ? 0 : 1;
    long now = nowMicros.getAsLong();
    if (terminal.redraws()) {
      String line = terminal.fitted(line(now));
      terminal.out().print("\r" + line + CLEAR_TO_END_OF_LINE + (done == runs ? "\n" : ""));
      terminal.out().flush();
    } else if (done == runs || now - shownMicros >= LINE_EVERY_US) {
      shownMicros = now;
      terminal.out().println(line(now));
    }
  }

  private String line(long now) {
    int filled = BAR_WIDTH * done / runs;
    double elapsedS = (now - startMicros) / 1e6;
    long leftS = Math.round(elapsedS / (done - before) * (runs - done));
    return String.format(
        Locale.ROOT,
        "[%s%s] %d of %d runs, %d failed, %s",
        "#".repeat(filled),
        ".".repeat(BAR_WIDTH - filled),
        done,
        runs,
        failed,
        done == runs
            ? clock(Math.round(elapsedS)) + " elapsed"
            : "about " + clock(leftS) + " left");
  }

  private static String clock(long seconds) {
    return String.format(
        Locale.ROOT, "%d:%02d:%02d", seconds / 3600, seconds / 60 % 60, seconds % 60);
  }
}
