package org.u2sa.interfaces.configuration;

import org.u2sa.interfaces.BadInputException;

/**
 * An invalid configuration. The message names file, line, variable, value and expectation, as far
 * as they exist.
 */
public class ConfigurationException extends BadInputException {
  private static final long serialVersionUID = 1L;

  /**
   * @param message file, line, variable, value and what was expected
   */
  public ConfigurationException(String message) {
    super(message);
  }

  /**
   * @param message file, line, variable, value and what was expected
   * @param cause what was caught
   */
  public ConfigurationException(String message, Throwable cause) {
    super(message, cause);
  }
}
