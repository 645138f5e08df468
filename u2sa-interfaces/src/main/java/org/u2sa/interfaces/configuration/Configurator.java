package org.u2sa.interfaces.configuration;

import java.util.ArrayList;
import java.util.Map;

/**
 * Reads and changes the named variables of a service, which persist in its configuration file
 * (thesis 3.2.1.1). Values are of the thesis's four types: {@link Integer}, {@link Double}, {@link
 * Boolean}, {@link String}.
 */
public interface Configurator {
  /**
   * The value of a variable, in its declared unit if a service declared it, otherwise in the
   * file's.
   *
   * @throws ConfigurationException if there is no such variable
   */
  Object getVariable(String variableName);

  /**
   * Declares a variable and reads it: the file's value in the declared unit, or the declared
   * default if the file has none.
   *
   * @throws ConfigurationException if it is required and absent, of another type, of a unit that
   *     cannot be converted, or outside its range; names file, line, variable, value and range
   */
  <T> T getVariable(VariableDeclaration<T> variable);

  /**
   * Declares and reads the variables of a record ({@link Variable}), which stay live.
   *
   * @throws ConfigurationException as {@link #getVariable(VariableDeclaration)} says, and if the
   *     record refuses the values together
   * @throws IllegalArgumentException if it is no such record
   */
  default <T> Settings<T> settings(Class<T> record) {
    return settings(record, "");
  }

  /**
   * {@link #settings(Class)} where a service has several of a kind.
   *
   * @param prefix before each variable's name, such as {@code "LEFT MOTOR "}
   */
  <T> Settings<T> settings(Class<T> record, String prefix);

  /**
   * Changes a variable and writes it to the configuration file; a power cut leaves the old or the
   * new file, whole.
   *
   * @param value in the declared unit; a value of the variable's type or its text
   * @return false if the value was refused or could not be written: then the old value stays, in
   *     memory and on file, and the service writes the reason to its log
   */
  boolean setVariable(String variableName, Object value);

  /** Every variable that may be set, with its present value; the list is the caller's own. */
  ArrayList<Map.Entry<String, Object>> enumerateFields();
}
