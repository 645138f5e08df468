package org.u2sa.interfaces.log;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.u2sa.interfaces.OneLine;
import org.u2sa.interfaces.time.Clock;

/**
 * A line of a {@link LogFile}.
 *
 * @param micros time of the run's clock [µs]
 * @param message text, which may have several lines
 * @param dropped lines dropped directly before it
 */
record FileLine(long micros, long thread, LogLevelEnum level, String message, long dropped) {
  private static final long NANOS_PER_MICRO = 1_000L;
  private static final DateTimeFormatter TIMESTAMP =
      DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm:ss.SSSSSS'Z'").withZone(ZoneOffset.UTC);
  private static final String SEPARATOR = " | ";
  private static final Pattern LINE_END = Pattern.compile("\\R");
  private static final String NEXT_LINE = "\n    ";
  private static final int MAX_MESSAGE_CHARS = 4_000;
  private static final int MAX_TRACE_CHARS = 16_000;
  private static final int CHARS_OF_START = 64; // rounded up, with the line's object

  /**
   * @param thrown cause, whose stack trace follows; or null
   */
  static String message(String message, Throwable thrown) {
    String text = shortened(String.valueOf(message), MAX_MESSAGE_CHARS);
    if (thrown != null) {
      StringWriter trace = new StringWriter();
      thrown.printStackTrace(new PrintWriter(trace, true));
      text += "\n" + shortened(trace.toString().trim(), MAX_TRACE_CHARS);
    }
    return text;
  }

  private static String shortened(String text, int maxChars) {
    return text.length() <= maxChars
        ? text
        : text.substring(0, maxChars) + "… (" + (text.length() - maxChars) + " more characters)";
  }

  /** Approximate memory that it takes, in characters. */
  int chars() {
    return CHARS_OF_START + message.length();
  }

  FileLine aboutLost(long lines) {
    String text =
        lines + (lines == 1 ? " line" : " lines") + " before this one could not be written";
    return new FileLine(micros, thread, LogLevelEnum.WARN, text, 0);
  }

  void appendTo(StringBuilder text, String serviceName) {
    Instant time =
        Instant.ofEpochSecond(
            Math.floorDiv(micros, Clock.MICROS_PER_SECOND),
            Math.floorMod(micros, Clock.MICROS_PER_SECOND) * NANOS_PER_MICRO);
    text.append(TIMESTAMP.format(time)).append(SEPARATOR);
    text.append(level).append(SEPARATOR);
    text.append(serviceName).append(SEPARATOR);
    text.append(thread).append(SEPARATOR);
    text.append(
            LINE_END.splitAsStream(message).map(OneLine::of).collect(Collectors.joining(NEXT_LINE)))
        .append('\n');
  }
}
