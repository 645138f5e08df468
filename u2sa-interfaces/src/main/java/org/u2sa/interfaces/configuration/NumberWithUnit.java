package org.u2sa.interfaces.configuration;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A number with a unit, as people type it: {@code 25 deg}.
 *
 * @param number as typed, which {@link Double#parseDouble} reads
 * @param unit as typed; {@link Units} knows whether there is such a one
 */
public record NumberWithUnit(String number, String unit) {
  /** Possessive, or the end of a number without a unit would be taken for one. */
  private static final Pattern FORM =
      Pattern.compile(
          "\\s*([+-]?+(?:\\d++\\.?+\\d*+|\\.\\d++)(?:[eE][+-]?+\\d++)?+)\\s*+([^\\s\\d].*?)\\s*");

  /** What the text holds; empty if it is no number, or one without a unit. */
  public static Optional<NumberWithUnit> of(String text) {
    Matcher form = FORM.matcher(text);
    return form.matches()
        ? Optional.of(new NumberWithUnit(form.group(1), form.group(2)))
        : Optional.empty();
  }

  double value() {
    return Double.parseDouble(number);
  }

  /**
   * The number in another unit.
   *
   * @throws IllegalArgumentException if the unit is none, or of something else
   */
  public double in(String other) {
    return Units.convert(value(), unit, other);
  }
}
