package org.u2sa.interfaces.configuration;

import org.u2sa.interfaces.units.NumberText;

/**
 * Allowed range of a variable.
 *
 * @param min negative infinity if none
 * @param max inclusive; positive infinity if none
 * @param minExcluded whether {@code min} is exclusive
 */
public record Range(double min, double max, boolean minExcluded) {
  private static final Range ANY =
      new Range(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, false);

  /**
   * @throws IllegalArgumentException if a bound is NaN or the range is empty
   */
  public Range {
    if (!(min < max || min == max && !minExcluded)) {
      throw new IllegalArgumentException(
          "a range " + (minExcluded ? "above " : "from ") + min + " to " + max + " is empty");
    }
  }

  /**
   * Inclusive range.
   *
   * @throws IllegalArgumentException if a bound is NaN or {@code min} is above {@code max}
   */
  public static Range of(double min, double max) {
    return new Range(min, max, false);
  }

  /** {@link #of} with exclusive {@code min}. */
  public static Range above(double min, double max) {
    return new Range(min, max, true);
  }

  /** Greater than zero. */
  public static Range positive() {
    return above(0.0, Double.POSITIVE_INFINITY);
  }

  /** Zero or greater. */
  public static Range nonNegative() {
    return of(0.0, Double.POSITIVE_INFINITY);
  }

  public static Range any() {
    return ANY;
  }

  public boolean isAny() {
    return min == Double.NEGATIVE_INFINITY && max == Double.POSITIVE_INFINITY;
  }

  /** Whether {@code value} is in this range; NaN and infinity never are. */
  public boolean contains(double value) {
    return Double.isFinite(value) && (minExcluded ? value > min : value >= min) && value <= max;
  }

  /** Copy with other bounds; an unchanged lower bound keeps its exclusivity. */
  Range between(double newMin, double newMax) {
    return new Range(newMin, newMax, minExcluded && newMin == min);
  }

  /** {@code 0…500}, {@code above 0}, {@code at least 0}, {@code at most 7}, {@code any number}. */
  @Override
  public String toString() {
    return withUnit("");
  }

  /**
   * Reason for excluding a value: {@code 95 deg is outside 0…60 deg}, {@code -3 m is not above 0
   * m}.
   */
  String refusal(String value, String unit) {
    if (Double.isInfinite(min) || Double.isInfinite(max)) {
      return value + " is not " + withUnit(unit);
    }
    String without = minExcluded ? " (" + NumberText.of(min) + " itself is also outside)" : "";
    return value + " is outside " + of(min, max).withUnit(unit) + without;
  }

  /** {@link #toString()} followed by the unit: {@code 0…60 deg}. */
  String withUnit(String unit) {
    String behind = unit.isEmpty() ? "" : " " + unit;
    if (isAny()) {
      return "any number" + (unit.isEmpty() ? "" : " of " + unit);
    }
    if (max == Double.POSITIVE_INFINITY) {
      return (minExcluded ? "above " : "at least ") + NumberText.of(min) + behind;
    }
    if (min == Double.NEGATIVE_INFINITY) {
      return "at most " + NumberText.of(max) + behind;
    }
    return (minExcluded ? "above " : "") + NumberText.of(min) + "…" + NumberText.of(max) + behind;
  }
}
