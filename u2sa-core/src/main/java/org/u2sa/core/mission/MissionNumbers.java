package org.u2sa.core.mission;

import java.util.regex.Pattern;
import org.u2sa.interfaces.configuration.Units;
import org.u2sa.interfaces.xml.XmlElement;

/** MissionNumbers with units in files. */
public final class MissionNumbers {
  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

  private MissionNumbers() {}

  /**
   * The number in an element, converted from its attribute {@code unit}.
   *
   * @param ifUnset unit if there is no such attribute
   * @param to unit of the answer
   * @throws org.u2sa.interfaces.BadInputException if it is no number, or has another kind of unit
   */
  public static double converted(XmlElement element, String ifUnset, String to) {
    String unit = element.optionalAttribute("unit").orElse(ifUnset);
    if (!NUMBER.matcher(element.text()).matches()) {
      throw element.error(
          "\"" + element.text() + "\" is not a number" + (unit.isEmpty() ? "" : " of " + unit));
    }
    double value = Double.parseDouble(element.text());
    if (!Double.isFinite(value)) {
      throw element.error("\"" + element.text() + "\" is too large");
    }
    try {
      return Units.convert(value, unit, to);
    } catch (IllegalArgumentException e) {
      throw element.error(e.getMessage(), e);
    }
  }

  /** Refuses a number outside a range. */
  static double within(XmlElement element, double value, double min, double max, String what) {
    if (!(value >= min && value <= max)) {
      throw element.error(value + " is outside " + min + "…" + max + " " + what);
    }
    return value;
  }
}
