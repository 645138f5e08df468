package org.u2sa.interfaces.configuration;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * What a service says about one of its configuration variables: name, type, unit, range, default
 * and meaning. A record with {@link Variable}s says it shorter; this is for what is known only when
 * the service runs, such as a default that a subclass gives. Immutable: each call returns a new
 * one.
 *
 * <pre>{@code
 * static final VariableDeclaration<Double> GAIN =
 *     VariableDeclaration.number("HEADING GAIN", "%/rad").range(Range.of(0.0, 500.0)).ifAbsent(120.0)
 *         .describedAs("Difference of the wheels' speeds for each radian of heading error.");
 * }</pre>
 *
 * @param <T> {@link Double}, {@link Integer}, {@link String} or {@link Boolean}
 * @param name the name in the file, unique in its service
 * @param type the type that the file must give it
 * @param javaType the same
 * @param unit the unit in which the service gets it; empty text if none
 * @param range the numbers that it may take
 * @param ifAbsent the value if the file has none; empty if the file must have one
 * @param choices the only values that it may take; empty if there is no such list
 * @param description what it does; empty text if nobody said
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
  /**
   * @throws IllegalArgumentException without a name, or if range or choices exclude the default
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

  /** A decimal number in {@code unit}, for example {@code "m/s"}; empty text for a bare number. */
  public static VariableDeclaration<Double> number(String name, String unit) {
    return of(name, VariableType.DOUBLE, Double.class, unit);
  }

  /** A whole number without a unit: a count, a port. */
  public static VariableDeclaration<Integer> integer(String name) {
    return integer(name, "");
  }

  /** A whole number in {@code unit}; a file may not give it in another one. */
  public static VariableDeclaration<Integer> integer(String name, String unit) {
    return of(name, VariableType.INTEGER, Integer.class, unit);
  }

  /** A text: an address, a path, a name. */
  public static VariableDeclaration<String> text(String name) {
    return of(name, VariableType.STRING, String.class, "");
  }

  /** A yes or no. */
  public static VariableDeclaration<Boolean> flag(String name) {
    return of(name, VariableType.BOOLEAN, Boolean.class, "");
  }

  /**
   * The numbers that the variable may take, in its own unit.
   *
   * @throws IllegalArgumentException if it is not a number, or its default lies outside
   */
  public VariableDeclaration<T> range(Range newRange) {
    if (!type.isNumber()) {
      throw new IllegalArgumentException("variable \"" + name + "\" is not a number: no range");
    }
    return new VariableDeclaration<>(
        name, type, javaType, unit, newRange, ifAbsent, choices, description);
  }

  /**
   * The value if the file has none; without it the variable is required.
   *
   * @throws IllegalArgumentException if the range or the choices exclude it
   */
  public VariableDeclaration<T> ifAbsent(T value) {
    return new VariableDeclaration<>(
        name, type, javaType, unit, range, Optional.of(value), choices, description);
  }

  /** What the variable does, in a sentence for the user who sets it. */
  public VariableDeclaration<T> describedAs(String newDescription) {
    return new VariableDeclaration<>(
        name, type, javaType, unit, range, ifAbsent, choices, newDescription);
  }

  /** The only values that the variable may take; texts in exactly this case. */
  @SafeVarargs
  public final VariableDeclaration<T> oneOf(T... values) {
    List<T> only = new ArrayList<>();
    for (T value : values) {
      only.add(value);
    }
    return new VariableDeclaration<>(
        name, type, javaType, unit, range, ifAbsent, List.copyOf(only), description);
  }

  /** {@code value}, which is of this variable's type, as such. */
  T cast(Object value) {
    return javaType.cast(value);
  }

  /**
   * Why {@code value}, of this variable's type and unit, is refused: {@code 95 deg is outside …}.
   */
  Optional<String> refusal(Object value) {
    return refusal(value, unit, range, choices);
  }

  private static Optional<String> refusal(Object value, String unit, Range range, List<?> choices) {
    if (value instanceof Number number && !range.contains(number.doubleValue())) {
      return Optional.of(
          range.refusal(NumberText.ofValue(value) + (unit.isEmpty() ? "" : " " + unit), unit));
    }
    if (!choices.isEmpty() && !choices.contains(value)) {
      return Optional.of(quoted(value) + " is not one of " + text(choices));
    }
    return Optional.empty();
  }

  /** The choices as a message lists them: {@code "a", "b"}. */
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
