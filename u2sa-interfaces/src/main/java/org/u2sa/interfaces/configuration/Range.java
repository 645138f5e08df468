package org.u2sa.interfaces.configuration;

/**
 * The numbers that a variable may take, both ends included unless said otherwise.
 *
 * @param min the lower end; negative infinity if there is none
 * @param max the upper end; positive infinity if there is none
 * @param minExcluded whether {@code min} itself is outside
 */
public record Range(double min, double max, boolean minExcluded) {
  private static final Range ANY =
      new Range(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, false);

  /**
   * @throws IllegalArgumentException if an end is NaN or nothing lies between them
   */
  public Range {
    if (!(min < max || min == max && !minExcluded)) {
      throw new IllegalArgumentException(
          "a range " + (minExcluded ? "above " : "from ") + min + " to " + max + " holds nothing");
    }
  }

  /**
   * {@code min} to {@code max}, both included; infinite ends are open ends.
   *
   * @throws IllegalArgumentException if an end is NaN or {@code min} is above {@code max}
   */
  public static Range of(double min, double max) {
    return new Range(min, max, false);
  }

  /**
   * {@link #of}, without {@code min} itself.
   *
   * @throws IllegalArgumentException if nothing lies between them
   */
  public static Range above(double min, double max) {
    return new Range(min, max, true);
  }

  /** Above zero. */
  public static Range positive() {
    return above(0.0, Double.POSITIVE_INFINITY);
  }

  /** Zero and above. */
  public static Range nonNegative() {
    return of(0.0, Double.POSITIVE_INFINITY);
  }

  /** Every finite number. */
  public static Range any() {
    return ANY;
  }

  /** Whether there is neither a lower nor an upper end. */
  public boolean isAny() {
    return min == Double.NEGATIVE_INFINITY && max == Double.POSITIVE_INFINITY;
  }

  /** Whether the finite {@code value} lies in this range; NaN and infinity never do. */
  public boolean contains(double value) {
    return Double.isFinite(value) && (minExcluded ? value > min : value >= min) && value <= max;
  }

  /** This range between other ends: an end that stays keeps being excluded if it was. */
  Range between(double newMin, double newMax) {
    return new Range(newMin, newMax, minExcluded && newMin == min);
  }

  /**
   * For example {@code 0…500}, {@code above 0}, {@code at least 0}, {@code at most 7}, {@code any}.
   */
  @Override
  public String toString() {
    return withUnit("");
  }

  /**
   * Why this range does not take {@code value}, which is in words: {@code 95 deg is outside 0…60
   * deg}, {@code -3 m is not above 0 m}.
   */
  String refusal(String value, String unit) {
    if (Double.isInfinite(min) || Double.isInfinite(max)) {
      return value + " is not " + withUnit(unit);
    }
    String without = minExcluded ? " (" + NumberText.of(min) + " itself is outside, too)" : "";
    return value + " is outside " + of(min, max).withUnit(unit) + without;
  }

  /** {@link #toString()} with the unit behind it: {@code 0…60 deg}. */
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
