package org.u2sa.scenarios.vrx;

import java.util.Locale;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.world.sdf.SdfNumbers;

/** Reads elements of SDF; errors name file, line, element and value. */
final class SdfValues {
  private static final double FULL_LATITUDE_DEG = 90.0;

  private SdfValues() {}

  static String text(XmlElement parent, String name) {
    return parent.requiredChild(name).text().trim();
  }

  static double number(XmlElement parent, String name) {
    return numbers(parent.requiredChild(name), 1)[0];
  }

  /** A number that VRX's plugin has a default for. */
  static double number(XmlElement parent, String name, double ifAbsent) {
    return parent.child(name).map(each -> numbers(each, 1)[0]).orElse(ifAbsent);
  }

  static double[] numbers(XmlElement element, int count) {
    String[] words = element.text().trim().split("\\s+");
    if (words.length < count) {
      throw element.error(
          String.format(Locale.ROOT, "\"%s\": expected %d numbers", element.text(), count));
    }
    double[] numbers = new double[count];
    for (int i = 0; i < count; i++) {
      numbers[i] = SdfNumbers.parsed(element, words[i]);
    }
    return numbers;
  }

  /** A time above 0 [s]. */
  static double positive(XmlElement parent, String name) {
    double seconds = number(parent, name);
    if (!(seconds > 0.0)) {
      throw parent.requiredChild(name).error(seconds + " s: expected above 0");
    }
    return seconds;
  }

  /** The value as a latitude [deg]. */
  static double latitude(XmlElement element, double degrees) {
    if (!(Math.abs(degrees) <= FULL_LATITUDE_DEG)) {
      throw element.error(degrees + " deg: expected a latitude of -90 to 90");
    }
    return degrees;
  }
}
