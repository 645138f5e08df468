package org.u2sa.interfaces.configuration;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.interfaces.units.NumberWithUnit;
import org.u2sa.interfaces.xml.XmlElement;

/**
 * A variable's entry in a configuration file, validated as far as the file alone allows. Value and
 * limits are in the file's unit.
 *
 * @param place file and line, for messages
 * @param text value as written
 * @param unit empty if none is given
 */
record FileVariable(
    String place,
    String name,
    VariableType type,
    String text,
    Object value,
    Optional<String> unit,
    Range limits,
    String description) {
  static final String ELEMENT = "variable";

  static FileVariable of(XmlElement element) {
    element.refuseUnknownAttributes("name", "type", "value", "unit", "min", "max", "description");
    element.refuseUnknownChildren();
    element.refuseText();
    String name = element.attribute("name");
    if (name.trim().isEmpty()) {
      throw element.error("attribute \"name\" is empty");
    }
    String place = element.origin() + ", line " + element.line();
    String text =
        element
            .optionalAttribute("value")
            .orElseThrow(() -> error(place, name, "attribute \"value\" is missing"));
    VariableType type = type(element, place, name);
    Range limits = limits(element, place, name, type);
    Object value = parse(place, name, "value", type, text);
    Optional<String> unit = element.optionalAttribute("unit").map(String::trim);
    if (value instanceof Number number && !limits.contains(number.doubleValue())) {
      throw error(place, name, limits.refusal(text.trim() + behind(unit), unit.orElse("")));
    }
    return new FileVariable(
        place,
        name,
        type,
        text,
        value,
        unit,
        limits,
        element.optionalAttribute("description").orElse(""));
  }

  static FileVariable inMemory(String origin, String name, Object value) {
    Object typed = value instanceof InferredValue inferred ? inferred.value() : value;
    VariableType type =
        VariableType.of(typed)
            .orElseThrow(
                () ->
                    new IllegalArgumentException(
                        String.format(
                            "%s, variable \"%s\": %s is neither Integer, Double, Boolean nor String",
                            origin, name, value)));
    return new FileVariable(
        origin, name, type, String.valueOf(value), typed, Optional.empty(), Range.any(), "");
  }

  FileVariable withText(String newText) {
    return new FileVariable(
        place, name, type, newText, type.parse(newText), unit, limits, description);
  }

  /**
   * Copy converted to a decimal number, if one is declared: from an integer, or from a text of
   * number and unit.
   */
  FileVariable withType(VariableType wanted) {
    if (wanted != VariableType.DOUBLE) {
      return this;
    }
    if (value instanceof Integer whole) {
      return inMemory(place, name, whole.doubleValue());
    }
    return NumberWithUnit.of(text)
        .map(
            typed ->
                new FileVariable(
                    place,
                    name,
                    wanted,
                    typed.number(),
                    typed.value(),
                    Optional.of(typed.unit()),
                    limits,
                    description))
        .orElse(this);
  }

  ConfigurationException error(String what) {
    return error(place, name, what);
  }

  private static ConfigurationException error(String place, String name, String what) {
    return new ConfigurationException(place + ", variable \"" + name + "\": " + what);
  }

  private static VariableType type(XmlElement element, String place, String name) {
    String given =
        element
            .optionalAttribute("type")
            .orElseThrow(() -> error(place, name, "attribute \"type\" is missing"));
    return VariableType.named(given)
        .orElseThrow(
            () ->
                error(
                    place,
                    name,
                    String.format(
                        "unknown type \"%s\"; expected %s",
                        given,
                        Arrays.stream(VariableType.values())
                            .map(VariableType::xmlName)
                            .collect(Collectors.joining(", "))
                            .toLowerCase(Locale.ROOT))));
  }

  private static Range limits(XmlElement element, String place, String name, VariableType type) {
    Optional<String> min = element.optionalAttribute("min");
    Optional<String> max = element.optionalAttribute("max");
    if (!type.isNumber() && (min.isPresent() || max.isPresent())) {
      throw error(place, name, "min and max are for numbers, but the type is " + type.xmlName());
    }
    double lowest = min.map(text -> limit(place, name, "min", text)).orElse(Range.any().min());
    double highest = max.map(text -> limit(place, name, "max", text)).orElse(Range.any().max());
    if (lowest > highest) {
      throw error(place, name, "min " + min.get() + " is above max " + max.get());
    }
    return Range.of(lowest, highest);
  }

  private static double limit(String place, String name, String attribute, String text) {
    return (Double) parse(place, name, attribute, VariableType.DOUBLE, text);
  }

  private static Object parse(
      String place, String name, String attribute, VariableType type, String text) {
    try {
      return type.parse(text);
    } catch (IllegalArgumentException e) {
      throw new ConfigurationException(
          place + ", variable \"" + name + "\": " + attribute + " " + e.getMessage(), e);
    }
  }

  private static String behind(Optional<String> unit) {
    return unit.map(name -> " " + name).orElse("");
  }
}
