package org.u2sa.interfaces.units;

import java.math.BigDecimal;
import java.math.MathContext;

/** Human-readable number formatting without superfluous digits. */
public final class NumberText {
  /** Enough digits to distinguish limits, but few enough to hide rounding of unit conversions. */
  private static final MathContext DIGITS = new MathContext(10);

  private static final double PLAIN_BELOW = 1.0e15;
  private static final double PLAIN_FROM = 1.0e-6;

  private NumberText() {}

  /** {@code 60}, {@code 0.5}, {@code 1.2E-9}; at most ten significant digits. */
  public static String of(double value) {
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

  /** Decimals as {@link #of(double)}, integers and texts as-is. */
  public static String ofValue(Object value) {
    return value instanceof Double number ? of(number) : String.valueOf(value);
  }

  public static String withUnit(Object value, String unit) {
    return unit.isEmpty() ? ofValue(value) : ofValue(value) + " " + unit;
  }
}
