package org.u2sa.gcs.mavlink.parameter;

import io.dronefleet.mavlink.common.MavParamType;
import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.messages.contract.ConfigurationVariable;

/**
 * A configuration variable as a parameter: numbers unchanged, flags as 0 and 1, choices as their
 * index. Free texts are not parameters.
 *
 * @param name at most 16 characters
 * @param service the service whose variable it is
 */
record Parameter(String name, String service, ConfigurationVariable variable) {
  /** A value on the wire, in the type of the parameter. */
  record Value(MavParamType type, double number) {}

  private static final double LARGEST_INT = Integer.MAX_VALUE;

  /** Whether a variable can be a parameter. */
  static boolean isExpressible(ConfigurationVariable variable) {
    return !variable.variableType().equals("string") || choices(variable).size() > 1;
  }

  private static List<String> choices(ConfigurationVariable variable) {
    return variable.choices();
  }

  /** Its value; 0 if the text is not a value of its type. */
  Value value() {
    String text = variable.value().trim();
    try {
      return switch (variable.variableType()) {
        case "double" -> new Value(MavParamType.MAV_PARAM_TYPE_REAL32, Double.parseDouble(text));
        case "int" -> integer(Long.parseLong(text));
        case "boolean" -> integer(Boolean.parseBoolean(text) ? 1 : 0);
        default -> integer(Math.max(0, choices(variable).indexOf(text)));
      };
    } catch (NumberFormatException e) {
      return integer(0); // the service refuses such text
    }
  }

  private static Value integer(long number) {
    return new Value(
        MavParamType.MAV_PARAM_TYPE_INT32,
        Math.max(-LARGEST_INT - 1, Math.min(LARGEST_INT, number)));
  }

  /** A number as text in the variable's declared form; empty if that is impossible. */
  Optional<String> text(double number) {
    if (Double.isNaN(number) || Double.isInfinite(number)) {
      return Optional.empty();
    }
    if (variable.variableType().equals("double")) {
      return Optional.of(shortest((float) number));
    }
    if (number != Math.rint(number)) {
      return Optional.empty();
    }
    long whole = (long) number;
    return switch (variable.variableType()) {
      case "int" -> Optional.of(Long.toString(whole));
      case "boolean" ->
          whole == 0 || whole == 1 ? Optional.of(whole == 1 ? "true" : "false") : Optional.empty();
      default ->
          whole >= 0 && whole < choices(variable).size()
              ? Optional.of(choices(variable).get((int) whole))
              : Optional.empty();
    };
  }

  /** Shortest decimal that represents a float: a station's 0.1 is not 0.10000000149. */
  private static String shortest(float number) {
    return new BigDecimal(Float.toString(number)).toPlainString();
  }

  /** Whether a station's number equals the present value, within the precision of the wire. */
  boolean has(double number) {
    Value now = value();
    return now.type() == MavParamType.MAV_PARAM_TYPE_REAL32
        ? (float) now.number() == (float) number
        : now.number() == number;
  }

  /** Accepted values, in words. */
  String expectation() {
    if (!choices(variable).isEmpty()) {
      StringBuilder text = new StringBuilder();
      for (int i = 0; i < choices(variable).size(); i++) {
        text.append(i == 0 ? "" : ", ").append(i).append(" = ").append(choices(variable).get(i));
      }
      return text.toString();
    }
    return switch (variable.variableType()) {
      case "boolean" -> "0 = false, 1 = true";
      case "int" -> "a whole number";
      default -> "a finite number" + (variable.unit().isEmpty() ? "" : " of " + variable.unit());
    };
  }

  @Override
  public String toString() {
    return String.format(Locale.ROOT, "%s (%s, %s)", name, service, variable.name());
  }
}
