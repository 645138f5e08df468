package org.u2sa.interfaces.log;

/** Priority of a log line, lowest first (thesis 3.2.1.5). */
public enum LogLevelEnum {
  /** Information for developers. */
  DEBUG,
  /** Normal operation. */
  INFO,
  /** A problem the service can handle. */
  WARN,
  /** A problem that keeps the service from working. */
  ERROR
}
