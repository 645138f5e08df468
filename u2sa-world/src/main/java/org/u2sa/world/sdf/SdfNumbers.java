package org.u2sa.world.sdf;

import org.u2sa.interfaces.xml.XmlElement;

/** Numbers in elements of SDFormat and COLLADA, separated by spaces. */
public final class SdfNumbers {
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
      numbers[i] = parsed(element, words[i]);
    }
    return numbers;
  }

  /** A number among the words of an element. */
  public static double parsed(XmlElement element, String word) {
    double number;
    try {
      number = Double.parseDouble(word);
    } catch (NumberFormatException e) {
      throw element.error("\"" + word + "\" is not a number", e);
    }
    if (!(Math.abs(number) <= LARGEST)) {
      throw element.error("\"" + word + "\": expected a number up to 10,000,000");
    }
    return number;
  }

  /** Whether an element's text is SDFormat's yes. */
  static boolean isTrue(XmlElement element) {
    return isTrue(element.text());
  }

  static boolean isTrue(String word) {
    return word.equals("true") || word.equals("1");
  }

  /** A number above 0 in a required child. */
  static double positive(XmlElement parent, String name) {
    XmlElement child = parent.requiredChild(name);
    double value = of(child, 1)[0];
    if (!(value > 0.0)) {
      throw child.error("\"" + child.text() + "\": expected a number above 0");
    }
    return value;
  }
}
