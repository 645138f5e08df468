package org.u2sa.cli.record;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.util.Locale;
import org.u2sa.cli.terminal.RawTerminal;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.recorder.mcap.record.McapStatistics;
import org.u2sa.recorder.playback.Playback;
import org.u2sa.recorder.playback.RecordedSpan;

/** Keyboard control of a playback, with a status line. Does nothing without a terminal. */
final class PlaybackKeys implements AutoCloseable {
  private static final double SEEK_S = 5.0;
  private static final double RATE_FACTOR = 2.0;
  private static final double NANOS = 1e9;
  private static final int ESCAPE = 0x1B;
  private static final String TO_LINE_START_AND_CLEAR = "\r\u001b[K";

  private final Terminal terminal;
  private final RawTerminal keyboard; // null if none
  private boolean isLineOpen;

  private PlaybackKeys(Terminal terminal, RawTerminal keyboard) {
    this.terminal = terminal;
    this.keyboard = keyboard;
  }

  /** Starts reading the keyboard if input and output are a terminal. */
  static PlaybackKeys of(Terminal terminal, Playback playback) throws IOException {
    if (!terminal.redraws()) {
      return new PlaybackKeys(terminal, null);
    }
    RawTerminal keyboard = RawTerminal.open();
    Thread reader = new Thread(() -> read(System.in, playback), "u2sa-replay-keys");
    reader.setDaemon(true); // blocks until a key is pressed, possibly forever
    reader.start();
    return new PlaybackKeys(terminal, keyboard);
  }

  /** Handles keys until the stream ends. */
  static void read(InputStream keys, Playback playback) {
    try {
      for (int key = keys.read(); key >= 0; key = keys.read()) {
        if (key == ESCAPE && keys.read() == '[') {
          arrow(keys.read(), playback);
        } else {
          plain(key, playback);
        }
      }
    } catch (IOException e) {
      playback.end(); // the terminal is gone, and so is its user
    }
  }

  private static void plain(int key, Playback playback) {
    switch (key) {
      case ' ' -> playback.togglePause();
      case 's' -> playback.step();
      case 'q' -> playback.end();
      default -> {
        // not a command
      }
    }
  }

  private static void arrow(int key, Playback playback) {
    switch (key) {
      case 'A' -> playback.fasterBy(RATE_FACTOR);
      case 'B' -> playback.fasterBy(1.0 / RATE_FACTOR);
      case 'C' -> playback.seekBy(SEEK_S);
      case 'D' -> playback.seekBy(-SEEK_S);
      default -> {
        // not a command
      }
    }
  }

  void explain() {
    if (keyboard != null) {
      terminal
          .out()
          .println("space pause, s step, left/right 5 s back/forward, up/down rate, q end");
    }
  }

  void show(Playback.Position position, RecordedSpan span, McapStatistics statistics) {
    if (keyboard == null) {
      return;
    }
    String line =
        String.format(
            Locale.ROOT,
            "%8.2f of %.2f s  x%s%s",
            span.seconds(position.nanos()),
            (statistics.endNanos() - statistics.startNanos()) / NANOS,
            String.format(Locale.ROOT, "%.4g", position.rate()).replaceFirst("\\.?0+$", ""),
            position.isPaused() ? "  paused" : "");
    PrintWriter out = terminal.out();
    out.print(TO_LINE_START_AND_CLEAR + terminal.fitted(line));
    out.flush();
    isLineOpen = true;
  }

  @Override
  public void close() throws IOException {
    if (isLineOpen) {
      terminal.out().println();
    }
    if (keyboard != null) {
      keyboard.close();
    }
  }
}
