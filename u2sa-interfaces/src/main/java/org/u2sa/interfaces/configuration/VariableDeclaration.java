package org.u2sa.interfaces.configuration;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.interfaces.units.NumberText;

/**
 * Declaration of a configuration variable. A record with {@link Variable}s is shorter; use this for
 * properties known only at run time, such as a subclass's default. Immutable: each call returns a
 * copy.
 *
 * <pre>{@code
 * static final VariableDeclaration<Double> GAIN =
 *     VariableDeclaration.number("HEADING GAIN", "%/rad").range(Range.of(0.0, 500.0)).ifAbsent(120.0)
 *         .describedAs("Difference of the wheels' speeds for each radian of heading error.");
 * }</pre>
 *
 * @param <T> {@link Double}, {@link Integer}, {@link String} or {@link Boolean}
 * @param name name in the file, unique within the service
 * @param unit unit delivered to the service; empty if none
 * @param ifAbsent default; empty if the variable is required
 * @param choices allowed values; empty for any
 */
public record VariableDeclaration<T>(
    String name,
    VariableType type,
    Class<T> javaType,
    String unit,
    Range range,
    Optional<T> ifAbsent,
    List<T> choices,
    String description) {
  /** Magnitudes of a number other than 0: products and quotients of a few remain finite. */
  private static final Range MAGNITUDES = Range.of(1e-12, 1e12);

  /**
   * @throws IllegalArgumentException if the name is missing, or the default is not allowed
   */
  public VariableDeclaration {
    if (name.trim().isEmpty()) {
      throw new IllegalArgumentException("a variable needs a name");
    }
    Objects.requireNonNull(unit);
    Objects.requireNonNull(description);
    if (ifAbsent.isPresent()) {
      refusal(ifAbsent.get(), unit, range, choices)
          .ifPresent(
              reason -> {
                throw new IllegalArgumentException(
                    String.format(
                        "variable \"%s\" is declared with a default that it refuses: %s",
                        name, reason));
              });
    }
  }

  private static <T> VariableDeclaration<T> of(
      String name, VariableType type, Class<T> javaType, String unit) {
    return new VariableDeclaration<>(
        name, type, javaType, unit, Range.any(), Optional.empty(), Collections.emptyList(), "");
  }

  /**
   * Decimal number in {@code unit}, for example {@code "m/s"}; empty for a dimensionless number.
   */
  public static VariableDeclaration<Double> number(String name, String unit) {
    return of(name, VariableType.DOUBLE, Double.class, unit);
  }

  public static VariableDeclaration<Integer> integer(String name) {
    return integer(name, "");
  }

  /** Declares an integer in {@code unit}; files must use the same unit. */
  public static VariableDeclaration<Integer> integer(String name, String unit) {
    return of(name, VariableType.INTEGER, Integer.class, unit);
  }

  public static VariableDeclaration<String> text(String name) {
    return of(name, VariableType.STRING, String.class, "");
  }

  public static VariableDeclaration<Boolean> flag(String name) {
    return of(name, VariableType.BOOLEAN, Boolean.class, "");
  }

  /**
   * @throws IllegalArgumentException if the variable is not numeric, or the default lies outside
   */
  public VariableDeclaration<T> range(Range newRange) {
    if (!type.isNumber()) {
      throw new IllegalArgumentException("variable \"" + name + "\" is not a number: no range");
    }
    return new VariableDeclaration<>(
        name, type, javaType, unit, newRange, ifAbsent, choices, description);
  }

  /**
   * @throws IllegalArgumentException if range or choices exclude the default
   */
  public VariableDeclaration<T> ifAbsent(T value) {
    return new VariableDeclaration<>(
        name, type, javaType, unit, range, Optional.of(value), choices, description);
  }

  /** Sets the description for the user, a sentence. */
  public VariableDeclaration<T> describedAs(String newDescription) {
    return new VariableDeclaration<>(
        name, type, javaType, unit, range, ifAbsent, choices, newDescription);
  }

  /** Sets the allowed values; texts are case-sensitive. */
  @SafeVarargs
  public final VariableDeclaration<T> oneOf(T... values) {
    List<T> only = new ArrayList<>();
    for (T value : values) {
      only.add(value);
    }
    return new VariableDeclaration<>(
        name, type, javaType, unit, range, ifAbsent, List.copyOf(only), description);
  }

  T cast(Object value) {
    return javaType.cast(value);
  }

  /** Reason for rejecting a value in the declared unit: {@code 95 deg is outside …}. */
  Optional<String> refusal(Object value) {
    return refusal(value, unit, range, choices);
  }

  private static Optional<String> refusal(Object value, String unit, Range range, List<?> choices) {
    if (value instanceof Number number && !range.contains(number.doubleValue())) {
      return Optional.of(
          range.refusal(NumberText.ofValue(value) + (unit.isEmpty() ? "" : " " + unit), unit));
    }
    if (value instanceof Double number && number != 0.0 && !MAGNITUDES.contains(Math.abs(number))) {
      return Optional.of(
          NumberText.ofValue(value) + " is neither 0 nor of a magnitude from 1E-12 to 1E12");
    }
    if (!choices.isEmpty() && !choices.contains(value)) {
      return Optional.of(quoted(value) + " is not one of " + text(choices));
    }
    return Optional.empty();
  }

  String choicesText() {
    return text(choices);
  }

  private static String text(List<?> choices) {
    return choices.stream().map(VariableDeclaration::quoted).collect(Collectors.joining(", "));
  }

  private static String quoted(Object value) {
    return value instanceof String ? "\"" + value + "\"" : NumberText.ofValue(value);
  }

  @Override
  public String toString() {
    return String.format(
        "variable \"%s\" (%s%s)", name, type.xmlName(), unit.isEmpty() ? "" : ", " + unit);
  }
}
