package org.u2sa.interfaces.configuration;

import java.math.BigDecimal;
import java.math.MathContext;

/** Numbers as people read them in messages and tables: no needless digits. */
final class NumberText {
  /** Enough to tell limits apart, few enough to hide the rounding of a unit's conversion. */
  private static final MathContext DIGITS = new MathContext(10);

  private static final double PLAIN_BELOW = 1.0e15;
  private static final double PLAIN_FROM = 1.0e-6;

  private NumberText() {}

  /** {@code 60}, {@code 0.5}, {@code 1.2E-9}; at most ten significant digits. */
  static String of(double value) {
    double magnitude = Math.abs(value);
    if (!Double.isFinite(value)) {
      return Double.toString(value);
    }
    if (magnitude == 0.0) {
      return "0";
    }
    BigDecimal rounded = new BigDecimal(value).round(DIGITS).stripTrailingZeros();
    return magnitude < PLAIN_BELOW && magnitude >= PLAIN_FROM
        ? rounded.toPlainString()
        : rounded.toString();
  }

  /**
   * A value of a variable's type: numbers as {@link #of(double)}, integers whole, text as it is.
   */
  static String ofValue(Object value) {
    return value instanceof Double number ? of(number) : String.valueOf(value);
  }

  /** {@link #ofValue(Object)} with the unit behind it, if there is one. */
  static String withUnit(Object value, String unit) {
    return unit.isEmpty() ? ofValue(value) : ofValue(value) + " " + unit;
  }
}
