package org.u2sa.core.mission;

import java.util.regex.Pattern;
import org.u2sa.interfaces.configuration.Units;
import org.u2sa.interfaces.xml.XmlElement;

/** Numbers with units in files. */
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

  /** Refuses what is no longitude. */
  public static void checkLongitude(XmlElement element, double longitudeDeg) {
    within(element, longitudeDeg, -180.0, 180.0, "deg of longitude");
  }

  /** Refuses what is no latitude. */
  public static void checkLatitude(XmlElement element, double latitudeDeg) {
    within(element, latitudeDeg, -90.0, 90.0, "deg of latitude (x is longitude, y is latitude)");
  }

  /** Refuses a number outside a range. */
  private static void within(
      XmlElement element, double value, double min, double max, String what) {
    if (!(value >= min && value <= max)) {
      throw element.error(value + " is outside " + min + "…" + max + " " + what);
    }
  }
}
