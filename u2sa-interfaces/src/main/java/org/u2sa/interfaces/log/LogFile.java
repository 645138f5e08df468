package org.u2sa.interfaces.log;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.disk.DiskThread;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

/**
 * The log file of one service (thesis 3.2.1.5, 4.6.1.3, 8.2.3.1): each line has the run's time,
 * level, service, thread ID and message, and is passed to the operating system in one call. Never
 * throws: lines that cannot be written are counted, and the first failure is reported on standard
 * error.
 *
 * <p>In real time lines wait in a bounded queue for the {@link DiskThread}, so that no service
 * waits for a disk that hangs; further lines are dropped, counted, and reported in the next line.
 * In simulated time lines are written immediately.
 *
 * <p>Uses no logging library, because Logback's file appender silently drops lines for a while
 * after a failure, and Android needs a different library.
 */
public final class LogFile implements AutoCloseable {
  private static final int MAX_WAITING_CHARS = 500_000;
  private static final int LINES_PER_JOB = 64; // then it is the turn of the other files
  private static final long CLOSES_WITHIN_MS = 1_000;
  private static final long HANGS_AFTER_MICROS = 2 * Clock.MICROS_PER_SECOND;

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
  private final DiskThread disk;
  private final Clock
      stopwatch; // not the run's clock: the number of reads differs in a re-execution
  private final LogFile first; // first of the logs sharing the file; owns the fields below
  private final AtomicLong failures = new AtomicLong();
  private final Deque<FileLine> waiting = new ArrayDeque<>(); // also the lock of the next four
  private int waitingChars;
  private boolean jobPending;
  private long dropped; // since the last line that was not
  private boolean closed;
  private OutputStream out; // this and the next three belong to the thread that writes
  private boolean lineBroken; // the last write failed, possibly mid-line
  private long lost; // lines lost since the last successful write
  private boolean said;

  /**
   * Appends to the file, creating it and its folder if absent.
   *
   * @param lowest minimum level written
   * @param clock clock of the run
   */
  public LogFile(Path file, String serviceName, LogLevelEnum lowest, Clock clock) {
    // A plain stream, because an interrupt would close a channel.
    this(
        file,
        serviceName,
        lowest,
        clock,
        System.err,
        path -> new FileOutputStream(path.toFile(), true),
        DiskThread.ofProcess(),
        new SystemClock());
  }

  LogFile(
      Path file,
      String serviceName,
      LogLevelEnum lowest,
      Clock clock,
      PrintStream complaints,
      Opener opener,
      DiskThread disk,
      Clock stopwatch) {
    this.file = file;
    this.serviceName = serviceName;
    this.lowest = lowest;
    this.clock = clock;
    this.complaints = complaints;
    this.opener = opener;
    this.disk = disk;
    this.stopwatch = stopwatch;
    first = this;
    if (clock.isSimulated()) {
      openEarly();
    } else {
      disk.execute(this::openEarly);
    }
  }

  private LogFile(LogFile before, Clock clock) {
    file = before.file;
    serviceName = before.serviceName;
    lowest = before.lowest;
    complaints = before.complaints;
    opener = before.opener;
    disk = before.disk;
    stopwatch = before.stopwatch;
    first = before.first;
    this.clock = clock;
  }

  /** Shares the open file with a successor service, which has its own clock. */
  public LogFile forSuccessor(Clock successors) {
    return new LogFile(this, successors);
  }

  public void log(LogLevelEnum level, String message) {
    log(level, message, null);
  }

  /**
   * Writes a line, with the stack trace if {@code thrown} is not null, unless the level is below
   * the minimum.
   */
  public void log(LogLevelEnum level, String message, Throwable thrown) {
    if (writes(level)) {
      long thread = Clock.runningThread().getId();
      first.add(clock.micros(), thread, level, FileLine.message(message, thrown));
    }
  }

  /** Whether the level is written. */
  public boolean writes(LogLevelEnum level) {
    return level.compareTo(lowest) >= 0;
  }

  private void add(long micros, long thread, LogLevelEnum level, String message) {
    synchronized (waiting) {
      FileLine line = new FileLine(micros, thread, level, message, dropped);
      if (closed) {
        return;
      }
      if (clock.isSimulated()) {
        write(line, true);
        return;
      }
      if (waitingChars + line.chars() > MAX_WAITING_CHARS) {
        dropped++;
        failures.incrementAndGet();
        return;
      }
      dropped = 0;
      waiting.add(line);
      waitingChars += line.chars();
      if (jobPending) {
        return;
      }
      jobPending = true;
    }
    disk.execute(this::writeSome);
  }

  private void writeSome() {
    for (int k = 0; k < LINES_PER_JOB; k++) {
      FileLine line;
      synchronized (waiting) {
        line = waiting.peek();
        jobPending = line != null;
      }
      if (line == null) {
        return;
      }
      try {
        write(line, k == 0);
      } finally {
        synchronized (waiting) { // only now: a line whose write hangs still waits
          waiting.remove();
          waitingChars -= line.chars();
        }
      }
    }
    disk.execute(this::writeSome);
  }

  /**
   * @param looksForFile whether to create the file again if somebody deleted or moved it
   */
  private void write(FileLine line, boolean looksForFile) {
    lost += line.dropped();
    try {
      if (out == null || looksForFile && !Files.exists(file)) {
        open();
      }
      StringBuilder text = new StringBuilder(lineBroken ? "\n" : "");
      if (lost > 0) {
        line.aboutLost(lost).appendTo(text, serviceName);
      }
      line.appendTo(text, serviceName);
      out.write(text.toString().getBytes(StandardCharsets.UTF_8));
      lineBroken = false;
      lost = 0;
    } catch (Exception | Error e) { // a full heap must not end the log
      lineBroken = out != null;
      lost++;
      failures.incrementAndGet();
      sayOnce(e);
    }
  }

  /**
   * Closes the file after writing pending lines, waiting at most a second for the disk; later lines
   * are dropped. Idempotent.
   */
  @Override
  public void close() {
    first.end();
  }

  private void end() {
    synchronized (waiting) {
      if (closed) {
        return;
      }
      closed = true;
    }
    if (clock.isSimulated()) {
      closeFile();
      return;
    }
    try {
      disk.call(
          () -> {
            writeRest();
            closeFile();
            return file;
          },
          CLOSES_WITHIN_MS);
    } catch (IOException e) {
      complaints.println(file + ": the last lines of " + serviceName + " are missing: " + e);
    }
  }

  private void writeRest() {
    while (true) {
      synchronized (waiting) {
        if (waiting.isEmpty()) {
          return;
        }
      }
      writeSome();
    }
  }

  private void closeFile() {
    try {
      if (out != null) {
        out.close();
      }
    } catch (IOException e) {
      sayOnce(e);
    }
    out = null;
  }

  public long failures() {
    return first.failures.get();
  }

  /** Fault of the file for health reports, such as a disk that hangs; empty if none. */
  public String trouble() {
    return first.findTrouble();
  }

  private String findTrouble() {
    synchronized (waiting) {
      FileLine oldest = waiting.peek();
      if (oldest != null && stopwatch.micros() - oldest.micros() > HANGS_AFTER_MICROS) {
        return "the disk does not answer; lines waiting: " + waiting.size();
      }
    }
    return failures.get() == 0 ? "" : failures.get() + " lines could not be written";
  }

  private void openEarly() {
    try {
      open();
    } catch (Exception | Error e) { // retried on each line, because it may become writable
      sayOnce(e);
    }
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
    RegularFile.refusePipe(file);
    out = opener.append(file);
  }

  private void sayOnce(Throwable e) {
    if (!said) {
      said = true;
      complaints.println(file + ": log of " + serviceName + " cannot be written: " + e);
    }
  }
}
