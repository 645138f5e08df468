package org.u2sa.interfaces.log;

/** Priority of a log line, lowest first (thesis 3.2.1.5). */
public enum LogLevelEnum {
  /** What only a developer wants to know. */
  DEBUG,
  /** What happens when all is well. */
  INFO,
  /** Something is wrong, and the service copes. */
  WARN,
  /** Something is wrong, and the service cannot do its work. */
  ERROR
}
