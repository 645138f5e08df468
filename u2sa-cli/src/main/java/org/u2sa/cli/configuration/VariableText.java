package org.u2sa.cli.configuration;

import org.u2sa.gcs.configuration.RemoteConfiguration;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.contract.ConfigurationVariable;

/**
 * An assignment {@code VARIABLE=VALUE} on the command line.
 *
 * @param variable the variable's name
 * @param value as typed, possibly a number with a unit
 */
record VariableText(String variable, String value) {
  /**
   * @throws IllegalArgumentException if there is no {@code =} after a name
   */
  static VariableText parse(String text) {
    int equals = text.indexOf('=');
    if (equals <= 0) {
      throw new IllegalArgumentException("\"" + text + "\": expected VARIABLE=VALUE");
    }
    return new VariableText(text.substring(0, equals).trim(), text.substring(equals + 1));
  }

  /**
   * The value as the service expects it: a number converted to the declared unit. Other text is
   * left for the service to validate.
   *
   * @throws BadInputException if the unit cannot be converted
   */
  String valueFor(ConfigurationVariable declared, String service) {
    return RemoteConfiguration.inUnitOf(declared, service, value);
  }
}
