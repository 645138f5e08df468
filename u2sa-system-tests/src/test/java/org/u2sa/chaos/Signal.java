package org.u2sa.chaos;

import java.io.IOException;
import java.io.UncheckedIOException;

/** Signals that Java cannot send. */
enum Signal {
  /** Freezes a process with all its threads. */
  STOP,
  /** Lets it go on. */
  CONT,
  /** Ends it without a word. */
  KILL;

  void send(ProcessHandle process) {
    try {
      new ProcessBuilder("kill", "-" + name(), String.valueOf(process.pid()))
          .redirectErrorStream(true)
          .start()
          .waitFor(); // it may have ended meanwhile: then there is nothing to signal
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
