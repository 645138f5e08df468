package org.u2sa.sim.file.element;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.frame.Point;

/**
 * An element of a vehicle file whose children are read as values in SI units. Missing values come
 * from the element's preset, if it names one. {@link #end} rejects children that were not read.
 */
public final class FileElement {
  private static final String UNIT = "unit";

  private final XmlElement element;
  private final Optional<FileElement> preset;
  private final Set<String> asked = new LinkedHashSet<>();

  /**
   * @param attributes attributes besides {@code preset}
   */
  public FileElement(XmlElement element, String... attributes) {
    this.element = element;
    element.refuseText();
    List<String> known = new ArrayList<>(List.of(attributes));
    boolean hasPresets = Presets.exist(element.name());
    if (hasPresets) {
      known.add(Presets.ATTRIBUTE);
    }
    element.refuseUnknownAttributes(known.toArray(new String[0]));
    preset =
        element
            .optionalAttribute(Presets.ATTRIBUTE)
            .filter(name -> hasPresets)
            .map(name -> Presets.find(element, name));
  }

  /** The element, for its name, attributes and position. */
  public XmlElement xml() {
    return element;
  }

  /** A required number. */
  public double number(String name, String unit, double min, double max) {
    XmlElement child = value(name).orElseThrow(() -> lacks(name, unit));
    return number(child, child.text(), unit, min, max);
  }

  /** An optional number. */
  public double number(String name, String unit, double min, double max, double ifAbsent) {
    return value(name).map(child -> number(child, child.text(), unit, min, max)).orElse(ifAbsent);
  }

  /** A required number above 0. */
  public double positive(String name, String unit, double max) {
    return number(name, unit, Double.MIN_NORMAL, max);
  }

  /** A required vector of three numbers. */
  public Point vector(String name, String unit, double min, double max) {
    XmlElement child = value(name).orElseThrow(() -> lacks(name, unit));
    return vector(child, unit, min, max);
  }

  /** An optional vector of three numbers. */
  public Point vector(String name, String unit, double min, double max, Point ifAbsent) {
    return value(name).map(child -> vector(child, unit, min, max)).orElse(ifAbsent);
  }

  /** A required vector of any length, as a unit vector. */
  public Point direction(String name) {
    return unit(name, vector(name, "1", -1e6, 1e6));
  }

  /** An optional vector of any length, as a unit vector. */
  public Point direction(String name, Point ifAbsent) {
    return unit(name, vector(name, "1", -1e6, 1e6, ifAbsent));
  }

  private Point unit(String name, Point way) {
    double length = way.distance();
    if (!(length > 1e-6)) {
      throw element.error(name + ": \"" + way + "\" has no length; expected a vector");
    }
    return Point.of(way.x() / length, way.y() / length, way.z() / length);
  }

  private static Point vector(XmlElement child, String unit, double min, double max) {
    List<Double> each = numbers(child, child.text(), unit, min, max);
    if (each.size() != 3) {
      throw child.error("\"" + child.text() + "\": expected three numbers of " + unit);
    }
    return Point.of(each.get(0), each.get(1), each.get(2));
  }

  /** A required list of numbers, with at least one and at most {@code most} of them. */
  public List<Double> numbers(String name, String unit, double min, double max, int most) {
    XmlElement child = value(name).orElseThrow(() -> lacks(name, unit));
    List<Double> each = numbers(child, child.text(), unit, min, max);
    if (each.isEmpty() || each.size() > most) {
      throw child.error("holds " + each.size() + " numbers; expected 1…" + most);
    }
    return each;
  }

  private static List<Double> numbers(
      XmlElement child, String text, String unit, double min, double max) {
    List<Double> each = new ArrayList<>();
    for (String part : text.isEmpty() ? new String[0] : text.split("[\\s,;]+")) {
      each.add(number(child, part, unit, min, max));
    }
    return each;
  }

  private static double number(XmlElement child, String text, String unit, double min, double max) {
    XmlElement part =
        new XmlElement(
            child.origin(),
            child.name(),
            child.line(),
            child.span(),
            child.attributes(),
            List.of(),
            text);
    double value = XmlNumbers.converted(part, unit, unit);
    if (!(value >= min && value <= max)) {
      String range = min == Double.MIN_NORMAL ? "above 0 and at most " + max : min + "…" + max;
      throw child.error(value + " " + unit + ": expected " + range + " " + unit);
    }
    return value;
  }

  /** A required whole number. */
  public int count(String name, int min, int max) {
    double value = number(name, "1", min, max);
    if (value != Math.rint(value)) {
      throw value(name).orElseThrow().error(value + ": expected a whole number");
    }
    return (int) value;
  }

  /** A required text. */
  public String text(String name) {
    String text = value(name).orElseThrow(() -> lacks(name, "")).text();
    if (text.isEmpty()) {
      throw value(name).orElseThrow().error("is empty; expected text");
    }
    return text;
  }

  /** A required constant of an enumeration. */
  public <E extends Enum<E>> E choice(String name, Class<E> type) {
    String text = text(name);
    for (E each : type.getEnumConstants()) {
      if (each.name().equals(text.toUpperCase(Locale.ROOT))) {
        return each;
      }
    }
    throw value(name)
        .orElseThrow()
        .error("\"" + text + "\": expected one of " + List.of(type.getEnumConstants()));
  }

  private Optional<XmlElement> value(String name) {
    asked.add(name);
    Optional<XmlElement> own = element.child(name);
    own.ifPresent(
        child -> {
          child.refuseUnknownAttributes(UNIT);
          child.refuseUnknownChildren();
        });
    return own.isPresent() ? own : preset.flatMap(usual -> usual.value(name));
  }

  private BadInputException lacks(String name, String unit) {
    return element.error(
        "lacks <" + name + ">" + (unit.isEmpty() ? "" : "; expected a value in " + unit));
  }

  /** Whether a child is present, here or in the preset. */
  public boolean has(String name) {
    asked.add(name);
    return element.child(name).isPresent() || preset.isPresent() && preset.get().has(name);
  }

  /** A required child that has children. */
  public FileElement part(String name) {
    return optionalPart(name).orElseThrow(() -> element.error("lacks <" + name + ">"));
  }

  /** An optional child that has children. */
  public Optional<FileElement> optionalPart(String name, String... attributes) {
    asked.add(name);
    return element.child(name).map(child -> new FileElement(child, attributes));
  }

  /** All children of a name. */
  public List<FileElement> parts(String name, String... attributes) {
    asked.add(name);
    return element.children(name).stream()
        .map(child -> new FileElement(child, attributes))
        .toList();
  }

  /** Constructs an object from values read before; its constructor may reject their combination. */
  public <T> T made(Supplier<T> maker) {
    try {
      return maker.get();
    } catch (BadInputException e) {
      throw e;
    } catch (IllegalArgumentException e) {
      throw element.error(e.getMessage(), e);
    }
  }

  /** Constructs an object from all children, and rejects the first child that was not read. */
  public <T> T complete(Supplier<T> maker) {
    T made = made(maker);
    end();
    return made;
  }

  /**
   * Call when everything is read.
   *
   * @throws BadInputException at the first child that was not read
   */
  public void end() {
    element.refuseUnknownChildren(asked.toArray(new String[0]));
  }
}
