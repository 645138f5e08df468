package org.u2sa.interfaces.configuration;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/** The types of the thesis's configuration variables (3.2.1.1, 4.5.1.2). */
public enum VariableType {
  /** Any text, including the empty text. */
  STRING("string", String.class, "a text"),
  /** A finite decimal number. */
  DOUBLE("double", Double.class, "a number"),
  /** A 32-bit integer; {@code integer} in a file is equivalent. */
  INTEGER("int", Integer.class, "a whole number from -2147483648 to 2147483647"),
  /** {@code true} or {@code false}, case-insensitive. */
  BOOLEAN("boolean", Boolean.class, "true or false");

  // Double.parseDouble also accepts NaN, Infinity, hexadecimal and 1d.
  private static final Pattern DECIMAL =
      Pattern.compile("[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?");

  private final String xmlName;
  private final Class<?> javaType;
  private final String expected;

  VariableType(String xmlName, Class<?> javaType, String expected) {
    this.xmlName = xmlName;
    this.javaType = javaType;
    this.expected = expected;
  }

  public String xmlName() {
    return xmlName;
  }

  public boolean isNumber() {
    return this == DOUBLE || this == INTEGER;
  }

  public static Optional<VariableType> named(String xmlName) {
    String wanted = xmlName.trim().toLowerCase(Locale.ROOT);
    if (wanted.equals("integer")) {
      return Optional.of(INTEGER);
    }
    return Arrays.stream(values()).filter(type -> type.xmlName.equals(wanted)).findFirst();
  }

  /** Empty if the class is not supported. */
  public static Optional<VariableType> of(Object value) {
    return Arrays.stream(values()).filter(type -> type.javaType.isInstance(value)).findFirst();
  }

  /**
   * Ignores spaces around numbers and booleans.
   *
   * @throws IllegalArgumentException if the text is invalid: {@code "abc" is not a number}
   */
  public Object parse(String text) {
    String trimmed = text.trim();
    switch (this) {
      case STRING:
        return text;
      case BOOLEAN:
        if (trimmed.equalsIgnoreCase("true") || trimmed.equalsIgnoreCase("false")) {
          return trimmed.equalsIgnoreCase("true");
        }
        throw refused(text);
      case INTEGER:
        try {
          return Integer.valueOf(trimmed);
        } catch (NumberFormatException e) {
          throw refused(text);
        }
      default:
        if (!DECIMAL.matcher(trimmed).matches()) {
          throw refused(text);
        }
        double number = Double.parseDouble(trimmed);
        if (Double.isInfinite(number)) {
          throw new IllegalArgumentException("\"" + text + "\" is too large for a number");
        }
        return number;
    }
  }

  /**
   * Returns a value of this type as-is, a text parsed, an integer as a decimal number.
   *
   * @throws IllegalArgumentException if it has another type
   */
  Object convert(Object value) {
    if (javaType.isInstance(value)) {
      if (value instanceof Double number && !Double.isFinite(number)) {
        throw refused(value);
      }
      return value;
    }
    if (this == DOUBLE && value instanceof Integer whole) {
      return whole.doubleValue();
    }
    if (value instanceof String text) {
      return parse(text);
    }
    throw refused(value);
  }

  private IllegalArgumentException refused(Object value) {
    String shown = value instanceof String text ? "\"" + text + "\"" : String.valueOf(value);
    return new IllegalArgumentException(shown + " is not " + expected);
  }
}
