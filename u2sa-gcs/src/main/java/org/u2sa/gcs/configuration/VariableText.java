package org.u2sa.gcs.configuration;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Units;
import org.u2sa.messages.contract.ConfigurationVariable;

/**
 * {@code VARIABLE=VALUE} of the command line.
 *
 * @param variable the variable's name
 * @param value as typed, perhaps a number with a unit
 */
record VariableText(String variable, String value) {
  /** Possessive, or the end of a number without a unit would be taken for one. */
  private static final Pattern QUANTITY =
      Pattern.compile(
          "\\s*([+-]?+(?:\\d++\\.?+\\d*+|\\.\\d++)(?:[eE][+-]?+\\d++)?+)\\s*+([^\\s\\d].*?)\\s*");

  /**
   * @throws IllegalArgumentException if there is no {@code =} behind a name
   */
  static VariableText parse(String text) {
    int equals = text.indexOf('=');
    if (equals <= 0) {
      throw new IllegalArgumentException("\"" + text + "\": expected VARIABLE=VALUE");
    }
    return new VariableText(text.substring(0, equals).trim(), text.substring(equals + 1));
  }

  /**
   * The value as its service takes it: a number in the declared unit; what is no number with a unit
   * is left for the service to judge.
   *
   * @throws BadInputException if the unit cannot be converted
   */
  String valueFor(ConfigurationVariable declared, String service) {
    Matcher quantity = QUANTITY.matcher(value);
    boolean number = declared.variableType().equals("double") && !declared.unit().isEmpty();
    if (!number || !quantity.matches()) {
      return value;
    }
    if (quantity.group(2).equals(declared.unit())) {
      return quantity.group(1);
    }
    try {
      return Double.toString(
          Units.convert(Double.parseDouble(quantity.group(1)), quantity.group(2), declared.unit()));
    } catch (IllegalArgumentException e) {
      throw new BadInputException(
          service + ", variable \"" + variable + "\": " + e.getMessage(), e);
    }
  }
}
