package org.u2sa.core.mission;

import org.u2sa.interfaces.Units;
import org.u2sa.interfaces.xml.XmlElement;

/** Numbers with units in mission files. */
final class Numbers {
  private Numbers() {}

  /**
   * The number in an element, converted from its attribute {@code unit}.
   *
   * @param ifUnset unit if there is no such attribute; may be empty if there is
   * @param to unit of the answer
   */
  static double converted(XmlElement element, String ifUnset, String to) {
    double value = number(element);
    try {
      return Units.convert(value, element.optionalAttribute("unit").orElse(ifUnset), to);
    } catch (IllegalArgumentException e) {
      throw element.error(e.getMessage(), e);
    }
  }

  private static double number(XmlElement element) {
    try {
      double value = Double.parseDouble(element.text());
      if (Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw element.error("\"" + element.text() + "\" is not a number", e);
    }
    throw element.error("\"" + element.text() + "\" is not a finite number");
  }

  /** Refuses a number outside a range. */
  static double within(XmlElement element, double value, double min, double max, String what) {
    if (!(value >= min && value <= max)) {
      throw element.error(value + " is outside " + min + "…" + max + " " + what);
    }
    return value;
  }
}
