package org.u2sa.interfaces.configuration;

import org.u2sa.interfaces.BadInputException;

/**
 * A configuration that cannot be used. The message names file, line, variable, value and what was
 * expected, as far as each exists.
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
