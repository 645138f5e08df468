package org.u2sa.service;

import java.util.regex.Pattern;
import org.u2sa.interfaces.configuration.ConfigurationException;

/** The form of a service's name, which also names its log file and its MQTT client. */
final class ServiceName {
  private static final Pattern FORM = Pattern.compile("[A-Za-z0-9_][A-Za-z0-9 _.-]{0,63}");

  private ServiceName() {}

  /**
   * The name, if it is one.
   *
   * @throws ConfigurationException if not; names the variable that sets it
   */
  static String checked(String name) {
    if (!FORM.matcher(name).matches()) {
      throw new ConfigurationException(
          "service name \""
              + name
              + "\" (variable \"SERVICE NAME\"): expected 1 to 64 letters, digits, spaces, '_', '.' or '-', "
              + "beginning with a letter, digit or '_'");
    }
    return name;
  }
}
