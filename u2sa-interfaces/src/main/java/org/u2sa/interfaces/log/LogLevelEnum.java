package org.u2sa.interfaces.log;

import java.util.Arrays;
import java.util.Locale;

/** Priority of a log line, lowest first (thesis 3.2.1.5). */
public enum LogLevelEnum {
  /** What only a developer wants to know. */
  DEBUG,
  /** What happens when all is well. */
  INFO,
  /** Something is wrong, and the service copes. */
  WARN,
  /** Something is wrong, and the service cannot do its work. */
  ERROR;

  /**
   * The level of that name, in any case.
   *
   * @throws IllegalArgumentException if there is none; names the levels
   */
  public static LogLevelEnum named(String name) {
    return Arrays.stream(values())
        .filter(level -> level.name().equals(name.trim().toUpperCase(Locale.ROOT)))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "\"" + name + "\" is not a log level: DEBUG, INFO, WARN or ERROR"));
  }
}
