package org.u2sa.sim.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;

/** Values of an element's children, in SI units; errors name file, line, element and value. */
final class ElementValues {
  private ElementValues() {}

  static double number(XmlElement element, String name, String unit, double min, double max) {
    return number(required(element, name), unit, min, max);
  }

  static double number(
      XmlElement element, String name, String unit, double min, double max, double ifAbsent) {
    return element.child(name).map(child -> number(child, unit, min, max)).orElse(ifAbsent);
  }

  private static double number(XmlElement child, String unit, double min, double max) {
    child.refuseUnknownAttributes("unit");
    child.refuseUnknownChildren();
    double value = XmlNumbers.converted(child, unit, unit);
    if (!(value >= min && value <= max)) {
      throw child.error(value + " " + unit + ": expected " + min + "…" + max + " " + unit);
    }
    return value;
  }

  /** Numbers separated by blanks, commas or semicolons. */
  static List<Double> numbers(XmlElement child, String unit, double min, double max) {
    child.refuseUnknownAttributes("unit");
    child.refuseUnknownChildren();
    List<Double> all = new ArrayList<>();
    for (String part : child.text().isEmpty() ? new String[0] : child.text().split("[\\s,;]+")) {
      XmlElement one =
          new XmlElement(
              child.origin(),
              child.name(),
              child.line(),
              child.span(),
              child.attributes(),
              List.of(),
              part);
      all.add(number(one, unit, min, max));
    }
    return all;
  }

  static boolean flag(XmlElement element, String name) {
    Optional<XmlElement> child = element.child(name);
    if (child.isPresent() && !child.get().text().matches("true|false")) {
      throw child.get().error("\"" + child.get().text() + "\": expected true or false");
    }
    return child.isPresent() && child.get().text().equals("true");
  }

  /** A constant of an enumeration, case-insensitive, with "-" for "_". */
  static <E extends Enum<E>> E choice(XmlElement element, String name, Class<E> type, E ifAbsent) {
    Optional<XmlElement> child = element.child(name);
    if (child.isEmpty()) {
      return ifAbsent;
    }
    List<String> names = new ArrayList<>();
    for (E each : type.getEnumConstants()) {
      String text = each.name().toLowerCase(Locale.ROOT).replace('_', '-');
      if (text.equals(child.get().text().toLowerCase(Locale.ROOT))) {
        return each;
      }
      names.add(text);
    }
    throw child
        .get()
        .error("\"" + child.get().text() + "\": expected one of " + String.join(", ", names));
  }

  static XmlElement required(XmlElement element, String name) {
    return element.child(name).orElseThrow(() -> lacks(element, name));
  }

  static BadInputException lacks(XmlElement element, String name) {
    return element.error("lacks <" + name + ">");
  }
}
