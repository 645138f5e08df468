package org.u2sa.interfaces.configuration;

import java.util.ArrayList;
import java.util.Map;

/**
 * Reads and changes the named variables of a service, which persist in its configuration file
 * (thesis 3.2.1.1): {@link Integer}, {@link Double}, {@link Boolean} or {@link String}.
 */
public interface Configurator {
  /**
   * Value in the declared unit, or in the file's if undeclared.
   *
   * @throws ConfigurationException if the variable is unknown
   */
  Object getVariable(String variableName);

  /**
   * Declares a variable and reads it from the file, or takes the default.
   *
   * @throws ConfigurationException if it is required and absent, of another type, of an
   *     incompatible unit, or outside its range; names file, line, variable, value and range
   */
  <T> T getVariable(VariableDeclaration<T> variable);

  /**
   * Declares and reads the variables of a record ({@link Variable}), which stay live.
   *
   * @throws ConfigurationException as for {@link #getVariable(VariableDeclaration)}, and if the
   *     record rejects the combination
   */
  default <T> Settings<T> settings(Class<T> record) {
    return settings(record, "");
  }

  /**
   * {@link #settings(Class)} for a service with several instances of a record.
   *
   * @param prefix prefix of each name, such as {@code "LEFT MOTOR "}
   */
  <T> Settings<T> settings(Class<T> record, String prefix);

  /**
   * Changes a variable in memory and, atomically, in the file.
   *
   * @param value value of the variable's type or its text, in the declared unit
   * @return false if the value was rejected or could not be written: the old value is kept, and the
   *     reason logged
   */
  boolean setVariable(String variableName, Object value);

  /** All settable variables with their current values; the list belongs to the caller. */
  ArrayList<Map.Entry<String, Object>> enumerateFields();
}
