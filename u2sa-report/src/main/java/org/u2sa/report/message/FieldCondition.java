package org.u2sa.report.message;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.units.NumberWithUnit;
import org.u2sa.messages.schema.U2SAData;

/**
 * A condition on a field: {@code x > 5}, {@code psi >= 90 deg}, {@code sensorName = GPS}, {@code
 * sensorName ~ gps} (contains, case-insensitive). False if the field is absent, except {@code !=}.
 */
public final class FieldCondition {
  private static final Pattern FORM =
      Pattern.compile("\\s*([^\\s=!<>~]+)\\s*(=|!=|<=|>=|<|>|~)\\s*(.*?)\\s*");

  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

  private final FieldPath path;
  private final String operator;
  private final String operand;

  private FieldCondition(FieldPath path, String operator, String operand) {
    this.path = path;
    this.operator = operator;
    this.operand = operand;
  }

  /**
   * Parses a condition.
   *
   * @throws IllegalArgumentException if malformed
   */
  public static FieldCondition parse(String text) {
    Matcher form = FORM.matcher(text);
    if (!form.matches()) {
      throw new IllegalArgumentException(
          "\"" + text + "\": expected FIELD OPERATOR VALUE with one of = != < <= > >= ~");
    }
    FieldCondition condition =
        new FieldCondition(FieldPath.parse(form.group(1)), form.group(2), form.group(3));
    if (condition.operator.matches("[<>]=?") && condition.typed().isEmpty()) {
      throw new IllegalArgumentException(
          "\"" + text + "\": expected a number after " + condition.operator);
    }
    return condition;
  }

  /** The operand as a number and unit; the unit is empty if none was given. */
  private Optional<NumberWithUnit> typed() {
    return NUMBER.matcher(operand).matches()
        ? Optional.of(new NumberWithUnit(operand, ""))
        : NumberWithUnit.of(operand);
  }

  /**
   * Whether a message satisfies the condition.
   *
   * @throws IllegalArgumentException if the unit does not match the field's dimension
   */
  public boolean holds(U2SAData message) {
    Optional<Object> value = path.value(message);
    if (value.isEmpty()) {
      return operator.equals("!=");
    }
    if (operator.equals("~")) {
      return text(value.get()).toLowerCase(Locale.ROOT).contains(operand.toLowerCase(Locale.ROOT));
    }
    Optional<NumberWithUnit> number = typed();
    OptionalDouble own = path.number(message);
    if (own.isPresent() && number.isPresent() && value.get() instanceof Number) {
      double limit = operandIn(number.get(), message);
      return compares(Double.compare(own.getAsDouble() + 0.0, limit + 0.0)); // -0 equals 0
    }
    boolean same = text(value.get()).equals(operand);
    return operator.equals("=") ? same : operator.equals("!=") && !same;
  }

  private double operandIn(NumberWithUnit number, U2SAData message) {
    return number.unit().isEmpty()
        ? Double.parseDouble(number.number())
        : number.in(path.unit(message));
  }

  private boolean compares(int sign) {
    return switch (operator) {
      case "=" -> sign == 0;
      case "!=" -> sign != 0;
      case "<" -> sign < 0;
      case "<=" -> sign <= 0;
      case ">" -> sign > 0;
      default -> sign >= 0;
    };
  }

  private static String text(Object value) {
    return String.valueOf(value);
  }
}
