package org.u2sa.interfaces.log;

import java.io.FileOutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import org.u2sa.interfaces.time.Clock;

/**
 * The log file of one service (thesis 3.2.1.5, 4.6.1.3, 8.2.3.1): a line has the run's time, level,
 * service, thread ID and message. Each line is on its way to the disk when {@code log} returns.
 * Never throws into the service: a line that cannot be written is counted, and said once on
 * standard error.
 */
public final class LogFile implements AutoCloseable {
  private final LogLevelEnum lowest;
  private final Clock clock;
  private final LogLineWriter lines;

  /**
   * Appends to {@code file}; makes it and its folder if need be.
   *
   * @param lowest lowest level that is written
   * @param clock clock of the run, whose time stands in front of each line
   */
  public LogFile(Path file, String serviceName, LogLevelEnum lowest, Clock clock) {
    // An interrupt would close a channel; a plain stream writes on.
    this(
        file,
        serviceName,
        lowest,
        clock,
        System.err,
        path -> new FileOutputStream(path.toFile(), true));
  }

  LogFile(
      Path file,
      String serviceName,
      LogLevelEnum lowest,
      Clock clock,
      PrintStream complaints,
      LogLineWriter.Opener opener) {
    this.lowest = lowest;
    this.clock = clock;
    lines = new LogLineWriter(file, serviceName, complaints, opener);
    lines.start();
  }

  /** Writes a line, unless {@code level} is below the lowest that is written. */
  public void log(LogLevelEnum level, String message) {
    log(level, message, null);
  }

  /**
   * Writes a line with the stack trace of what went wrong, indented below it.
   *
   * @param thrown what went wrong, or null
   */
  public void log(LogLevelEnum level, String message, Throwable thrown) {
    if (writes(level)) {
      lines.write(clock.micros(), level, message, thrown);
    }
  }

  /** Whether lines of this level are written: spares the making of costly messages. */
  public boolean writes(LogLevelEnum level) {
    return level.compareTo(lowest) >= 0;
  }

  /** How many lines could not be written. */
  public long failures() {
    return lines.failures();
  }

  /** Closes the file; later lines are dropped. Safe to call twice. */
  @Override
  public void close() {
    lines.close();
  }
}
