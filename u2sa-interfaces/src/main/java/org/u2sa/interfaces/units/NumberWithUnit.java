package org.u2sa.interfaces.units;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A number with a unit, as typed by users: {@code 25 deg}. The unit is not validated. */
public record NumberWithUnit(String number, String unit) {
  /** Possessive quantifiers, so that the end of a bare number is not mistaken for a unit. */
  private static final Pattern FORM =
      Pattern.compile(
          "\\s*([+-]?+(?:\\d++\\.?+\\d*+|\\.\\d++)(?:[eE][+-]?+\\d++)?+)\\s*+([^\\s\\d].*?)\\s*");

  /** Empty unless the text is a number with a unit. */
  public static Optional<NumberWithUnit> of(String text) {
    Matcher form = FORM.matcher(text);
    return form.matches()
        ? Optional.of(new NumberWithUnit(form.group(1), form.group(2)))
        : Optional.empty();
  }

  public double value() {
    return Double.parseDouble(number);
  }

  /**
   * @throws IllegalArgumentException if a unit is unknown or measures a different quantity
   */
  public double in(String other) {
    return Units.convert(value(), unit, other);
  }
}
