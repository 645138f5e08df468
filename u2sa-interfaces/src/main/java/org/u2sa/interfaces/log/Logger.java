package org.u2sa.interfaces.log;

import org.u2sa.interfaces.configuration.Configurator;

/**
 * Writes lines to the log file of a service, in the one format that all services share (3.2.1.5).
 */
public interface Logger extends Configurator {
  /** Writes a line unless {@code level} is below the minimum written to file. */
  void log(LogLevelEnum level, String logMessage);
}
