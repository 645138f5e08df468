package org.u2sa.scenarios.vrx;

import java.util.Locale;
import org.u2sa.interfaces.xml.XmlElement;

/** Reads elements of SDF; errors name file, line, element and value. */
final class SdfValues {
  private static final double LARGEST = 1e7;
  private static final double FULL_LATITUDE_DEG = 90.0;

  private SdfValues() {}

  static XmlElement required(XmlElement parent, String name) {
    return parent.child(name).orElseThrow(() -> parent.error("lacks <" + name + ">"));
  }

  static String text(XmlElement parent, String name) {
    return required(parent, name).text().trim();
  }

  static double number(XmlElement parent, String name) {
    return numbers(required(parent, name), 1)[0];
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
      numbers[i] = parsed(element, words[i]);
    }
    return numbers;
  }

  static double parsed(XmlElement element, String word) {
    double number;
    try {
      number = Double.parseDouble(word);
    } catch (NumberFormatException e) {
      throw element.error("\"" + word + "\" is not a number", e);
    }
    if (!(Math.abs(number) <= LARGEST)) {
      throw element.error("\"" + word + "\": expected a number of at most 10,000,000");
    }
    return number;
  }

  /** A time above 0 [s]. */
  static double positive(XmlElement parent, String name) {
    double seconds = number(parent, name);
    if (!(seconds > 0.0)) {
      throw required(parent, name).error(seconds + " s: expected above 0");
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
