package org.u2sa.interfaces.log;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.u2sa.interfaces.OneLine;
import org.u2sa.interfaces.time.Clock;

/**
 * The log file of one service (thesis 3.2.1.5, 4.6.1.3, 8.2.3.1): each line has the run's time,
 * level, service, thread ID and message, and is passed to the operating system in one call before
 * {@code log} returns. Never throws: lines that cannot be written are counted, and the first
 * failure is reported on standard error.
 *
 * <p>Uses no logging library, because Logback's file appender silently drops lines for a while
 * after a failure, and Android needs a different library.
 */
public final class LogFile implements AutoCloseable {
  private static final long NANOS_PER_MICRO = 1_000L;
  private static final DateTimeFormatter TIMESTAMP =
      DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm:ss.SSSSSS'Z'").withZone(ZoneOffset.UTC);
  private static final String SEPARATOR = " | ";
  private static final Pattern LINE_END = Pattern.compile("\\R");
  private static final String NEXT_LINE = "\n    ";
  private static final int MAX_MESSAGE_CHARS = 4_000;
  private static final int MAX_TRACE_CHARS = 16_000;

  /** Opens a file for unbuffered appending, creating it if absent. */
  interface Opener {
    OutputStream append(Path file) throws IOException;
  }

  private final Path file;
  private final String serviceName;
  private final LogLevelEnum lowest;
  private final Clock clock;
  private final PrintStream complaints;
  private final Opener opener;
  private final LogFile first; // first of the logs sharing the file; owns the fields below
  private OutputStream out;
  private boolean lineBroken; // the last write failed, possibly mid-line
  private long lost; // lines lost since the last successful write
  private long failures;
  private boolean said;
  private boolean closed;

  /**
   * Appends to {@code file}, creating it and its folder if absent.
   *
   * @param lowest minimum level written
   * @param clock clock of the run, for line timestamps
   */
  public LogFile(Path file, String serviceName, LogLevelEnum lowest, Clock clock) {
    // A plain stream, because an interrupt would close a channel.
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
      Opener opener) {
    this.file = file;
    this.serviceName = serviceName;
    this.lowest = lowest;
    this.clock = clock;
    this.complaints = complaints;
    this.opener = opener;
    first = this;
    try {
      open();
    } catch (IOException e) { // retried on each line, because it may become writable
      sayOnce(e);
    }
  }

  private LogFile(LogFile before, Clock clock) {
    file = before.file;
    serviceName = before.serviceName;
    lowest = before.lowest;
    complaints = before.complaints;
    opener = before.opener;
    first = before.first;
    this.clock = clock;
  }

  /**
   * Shares the open file with a successor service.
   *
   * @param successors the successor's clock
   */
  public LogFile forSuccessor(Clock successors) {
    return new LogFile(this, successors);
  }

  /** Writes a line unless {@code level} is below the minimum. */
  public void log(LogLevelEnum level, String message) {
    log(level, message, null);
  }

  /**
   * Writes a line with an indented stack trace.
   *
   * @param thrown cause, or null
   */
  public void log(LogLevelEnum level, String message, Throwable thrown) {
    if (writes(level)) {
      first.write(clock.micros(), level, message, thrown);
    }
  }

  /** Whether this level is written, to avoid composing costly messages. */
  public boolean writes(LogLevelEnum level) {
    return level.compareTo(lowest) >= 0;
  }

  private synchronized void write(
      long micros, LogLevelEnum level, String message, Throwable thrown) {
    if (closed) {
      return;
    }
    try {
      if (out == null || !Files.exists(file)) {
        open();
      }
      StringBuilder text = new StringBuilder(lineBroken ? "\n" : "");
      if (lost > 0) {
        line(
            text,
            micros,
            LogLevelEnum.WARN,
            lost + (lost == 1 ? " line" : " lines") + " before this one could not be written");
      }
      line(text, micros, level, message(message, thrown));
      out.write(text.toString().getBytes(StandardCharsets.UTF_8));
      lineBroken = false;
      lost = 0;
    } catch (IOException e) {
      lineBroken = out != null;
      lost++;
      failures++;
      sayOnce(e);
    }
  }

  /** Closes the file; later lines are dropped. Idempotent. */
  @Override
  public void close() {
    first.end();
  }

  private synchronized void end() {
    closed = true;
    try {
      if (out != null) {
        out.close();
      }
    } catch (IOException e) {
      sayOnce(e);
    }
    out = null;
  }

  /** Number of lines that could not be written. */
  public long failures() {
    return first.countFailures();
  }

  private synchronized long countFailures() {
    return failures;
  }

  private void open() throws IOException {
    if (out != null) {
      out.close();
      out = null;
    }
    Path folder = file.toAbsolutePath().getParent();
    if (folder != null) {
      Files.createDirectories(folder);
    }
    out = opener.append(file);
  }

  private void line(StringBuilder text, long micros, LogLevelEnum level, String message) {
    Instant time =
        Instant.ofEpochSecond(
            Math.floorDiv(micros, Clock.MICROS_PER_SECOND),
            Math.floorMod(micros, Clock.MICROS_PER_SECOND) * NANOS_PER_MICRO);
    text.append(TIMESTAMP.format(time)).append(SEPARATOR);
    text.append(level).append(SEPARATOR);
    text.append(serviceName).append(SEPARATOR);
    text.append(Clock.runningThread().getId()).append(SEPARATOR);
    text.append(message).append('\n');
  }

  private static String message(String message, Throwable thrown) {
    String text = shortened(String.valueOf(message), MAX_MESSAGE_CHARS);
    if (thrown != null) {
      StringWriter trace = new StringWriter();
      thrown.printStackTrace(new PrintWriter(trace, true));
      text += "\n" + shortened(trace.toString().trim(), MAX_TRACE_CHARS);
    }
    return LINE_END.splitAsStream(text).map(OneLine::of).collect(Collectors.joining(NEXT_LINE));
  }

  /** Truncates long messages: foreign content must not fill the disk. */
  private static String shortened(String text, int maxChars) {
    return text.length() <= maxChars
        ? text
        : text.substring(0, maxChars) + "… (" + (text.length() - maxChars) + " more characters)";
  }

  private void sayOnce(IOException e) {
    if (!said) {
      said = true;
      complaints.println(file + ": log of " + serviceName + " cannot be written: " + e);
    }
  }
}
