package org.u2sa.interfaces;

import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.ThrowableProxyUtil;
import ch.qos.logback.core.AppenderBase;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;

/**
 * Writes each event as a line, with one system call, by the thread that logs. Logback's own file
 * appender drops lines uncounted for a while after a failure; this one tries, and counts, each.
 */
final class LogLineAppender extends AppenderBase<ILoggingEvent> {
  private static final DateTimeFormatter TIMESTAMP =
      DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm:ss.SSSSSS'Z'").withZone(ZoneOffset.UTC);
  private static final String SEPARATOR = " | ";
  private static final String NEXT_LINE = "\n    ";

  /** Opens a file for writing at its end, unbuffered; makes it if it is not there. */
  interface Opener {
    OutputStream append(Path file) throws IOException;
  }

  private final Path file;
  private final String serviceName;
  private final PrintStream complaints;
  private final Opener opener;
  private OutputStream out;
  private boolean lineBroken; // the last write failed, perhaps in the middle of its line
  private long lost; // lines since the last one that was written
  private long failures;
  private boolean said;

  LogLineAppender(Path file, String serviceName, PrintStream complaints, Opener opener) {
    this.opener = opener;
    this.complaints = complaints;
    this.file = file;
    this.serviceName = serviceName;
    setName(serviceName);
  }

  @Override
  public void start() {
    try {
      open();
    } catch (IOException e) {
      sayOnce(e); // the file may yet become writable: each line tries again
    }
    super.start();
  }

  // AppenderBase calls this under its lock.
  @Override
  protected void append(ILoggingEvent event) {
    try {
      if (out == null || !Files.exists(file)) {
        open();
      }
      StringBuilder text = new StringBuilder(lineBroken ? "\n" : "");
      if (lost > 0) {
        line(
            text,
            event,
            "WARN",
            lost + (lost == 1 ? " line" : " lines") + " before this one could not be written");
      }
      line(text, event, event.getLevel().toString(), message(event));
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

  @Override
  public synchronized void stop() {
    super.stop();
    try {
      if (out != null) {
        out.close();
      }
    } catch (IOException e) {
      sayOnce(e);
    }
    out = null;
  }

  synchronized long failures() {
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

  private void line(StringBuilder text, ILoggingEvent event, String level, String message) {
    text.append(TIMESTAMP.format(event.getInstant())).append(SEPARATOR);
    text.append(level).append(SEPARATOR);
    text.append(serviceName).append(SEPARATOR);
    text.append(Thread.currentThread().getId()).append(SEPARATOR);
    text.append(message).append('\n');
  }

  private static String message(ILoggingEvent event) {
    String message = String.valueOf(event.getMessage());
    if (event.getThrowableProxy() != null) {
      message += "\n" + ThrowableProxyUtil.asString(event.getThrowableProxy()).trim();
    }
    return message.replaceAll("\\R", NEXT_LINE);
  }

  private void sayOnce(IOException e) {
    if (!said) {
      said = true;
      complaints.println(file + ": log of " + serviceName + " cannot be written: " + e);
    }
  }
}
