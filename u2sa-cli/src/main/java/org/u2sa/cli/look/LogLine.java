package org.u2sa.cli.look;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.log.LogLevelEnum;

/**
 * An entry of a service's log.
 *
 * @param time time as written, in UTC of the run's clock; sortable as text
 * @param text text including continuation lines, such as a stack trace
 */
record LogLine(String time, LogLevelEnum level, String service, String thread, String text) {
  private static final Pattern FORM =
      Pattern.compile(
          "(\\S+Z) \\| (DEBUG|INFO|WARN|ERROR) \\| (.*?) \\| (\\d+) \\| (.*)", Pattern.DOTALL);

  /** Parses a log's entries; text before the first one is skipped. */
  static List<LogLine> of(String text) {
    List<LogLine> all = new ArrayList<>();
    StringBuilder entry = new StringBuilder();
    for (String line : text.split("\n")) {
      if (FORM.matcher(line).matches()) {
        add(entry, all);
        entry.setLength(0);
      } else {
        entry.append('\n');
      }
      entry.append(line);
    }
    add(entry, all);
    return all;
  }

  private static void add(StringBuilder entry, List<LogLine> all) {
    Matcher form = FORM.matcher(entry);
    if (form.matches()) {
      all.add(
          new LogLine(
              form.group(1),
              LogLevelEnum.valueOf(form.group(2)),
              form.group(3),
              form.group(4),
              form.group(5)));
    }
  }
}
