package org.u2sa.interfaces;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.spi.LoggingEvent;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.time.Instant;

/**
 * The log file of one service (thesis 3.2.1.5, 4.6.1.3, 8.2.3.1): a line has the run's time, level,
 * service, thread ID and message. Each line is on its way to the disk when {@code log} returns.
 * Never throws into the service: a line that cannot be written is counted, and said once on
 * standard error.
 */
public final class LogFile implements AutoCloseable {
  private static final long MICROS_PER_SECOND = 1_000_000L;
  private static final long NANOS_PER_MICRO = 1_000L;

  private final LogLevelEnum lowest;
  private final Clock clock;
  private final LoggerContext context = new LoggerContext();
  private final Logger logger;
  private final LogLineAppender appender;

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
      LogLineAppender.Opener opener) {
    this.lowest = lowest;
    this.clock = clock;
    appender = new LogLineAppender(file, serviceName, complaints, opener);
    appender.setContext(context);
    appender.start();
    logger = context.getLogger(serviceName.isEmpty() ? "service" : serviceName);
    logger.setLevel(Level.TRACE);
    logger.setAdditive(false);
    logger.addAppender(appender);
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
    if (!writes(level)) {
      return;
    }
    LoggingEvent event =
        new LoggingEvent(LogFile.class.getName(), logger, logback(level), message, thrown, null);
    long micros = clock.micros();
    event.setInstant(
        Instant.ofEpochSecond(
            Math.floorDiv(micros, MICROS_PER_SECOND),
            Math.floorMod(micros, MICROS_PER_SECOND) * NANOS_PER_MICRO));
    logger.callAppenders(event);
  }

  /** Whether lines of this level are written: spares the making of costly messages. */
  public boolean writes(LogLevelEnum level) {
    return level.compareTo(lowest) >= 0;
  }

  /** How many lines could not be written. */
  public long failures() {
    return appender.failures();
  }

  /** Closes the file; later lines are dropped. Safe to call twice. */
  @Override
  public void close() {
    context.stop();
  }

  private static Level logback(LogLevelEnum level) {
    switch (level) {
      case DEBUG:
        return Level.DEBUG;
      case INFO:
        return Level.INFO;
      case WARN:
        return Level.WARN;
      default:
        return Level.ERROR;
    }
  }
}
