package org.u2sa.interfaces.units;

import java.util.regex.Pattern;
import org.u2sa.interfaces.xml.XmlElement;

/** Numbers with units in files. */
public final class XmlNumbers {
  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

  private XmlNumbers() {}

  /**
   * Number in an element, converted from its {@code unit} attribute.
   *
   * @param ifUnset unit without the attribute
   * @throws org.u2sa.interfaces.BadInputException if it is not a number, or of another dimension
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

  public static void checkLongitude(XmlElement element, double longitudeDeg) {
    within(element, longitudeDeg, -180.0, 180.0, "deg of longitude");
  }

  public static void checkLatitude(XmlElement element, double latitudeDeg) {
    within(element, latitudeDeg, -90.0, 90.0, "deg of latitude (x is longitude, y is latitude)");
  }

  private static void within(
      XmlElement element, double value, double min, double max, String what) {
    if (!(value >= min && value <= max)) {
      throw element.error(value + " is outside " + min + "…" + max + " " + what);
    }
  }
}
