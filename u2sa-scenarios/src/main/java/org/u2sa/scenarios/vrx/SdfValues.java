package org.u2sa.scenarios.vrx;

import java.util.Locale;
import org.u2sa.interfaces.xml.XmlElement;

/** Reads elements of SDF; errors name file, line, element and value. */
final class SdfValues {
  private static final double LARGEST = 1e7;

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
      try {
        numbers[i] = Double.parseDouble(words[i]);
      } catch (NumberFormatException e) {
        throw element.error("\"" + words[i] + "\" is not a number", e);
      }
      if (!(Math.abs(numbers[i]) <= LARGEST)) {
        throw element.error("\"" + words[i] + "\": expected a number of at most 10,000,000");
      }
    }
    return numbers;
  }
}
