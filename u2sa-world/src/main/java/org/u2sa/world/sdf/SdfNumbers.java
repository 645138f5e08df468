package org.u2sa.world.sdf;

import org.u2sa.interfaces.xml.XmlElement;

/** Numbers in elements of SDFormat, separated by spaces. */
final class SdfNumbers {
  private static final double LARGEST = 1e7;

  private SdfNumbers() {}

  /**
   * All numbers of an element.
   *
   * @throws org.u2sa.interfaces.BadInputException unless there are exactly {@code count} of them
   */
  static double[] of(XmlElement element, int count) {
    String[] words = element.text().trim().split("\\s+");
    if (words.length != count) {
      throw element.error("\"" + element.text() + "\": expected " + count + " numbers");
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

  /** A number above 0 in a required child. */
  static double positive(XmlElement parent, String name) {
    XmlElement child = required(parent, name);
    double value = of(child, 1)[0];
    if (!(value > 0.0)) {
      throw child.error("\"" + child.text() + "\": expected a number above 0");
    }
    return value;
  }

  static XmlElement required(XmlElement parent, String name) {
    return parent.child(name).orElseThrow(() -> parent.error("lacks <" + name + ">"));
  }
}
