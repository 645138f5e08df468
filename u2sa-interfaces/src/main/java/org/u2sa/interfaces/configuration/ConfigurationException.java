package org.u2sa.interfaces.configuration;

import org.u2sa.interfaces.BadInputException;

/**
 * An invalid configuration. The message names file, line, variable, value and expectation, as far
 * as they exist.
 */
public class ConfigurationException extends BadInputException {
  private static final long serialVersionUID = 1L;

  public ConfigurationException(String message) {
    super(message);
  }

  public ConfigurationException(String message, Throwable cause) {
    super(message, cause);
  }
}
