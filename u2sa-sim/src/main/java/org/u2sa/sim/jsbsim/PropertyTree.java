package org.u2sa.sim.jsbsim;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.DoubleSupplier;
import org.u2sa.interfaces.xml.XmlElement;

/** The properties of one aircraft by JSBSim's names, in JSBSim's units. Not thread-safe. */
final class PropertyTree {
  /** A value that changes. */
  static final class Property {
    double value;
  }

  private final Map<String, Property> all = new HashMap<>();
  private final Map<String, Property> quick = new HashMap<>(); // by name, as spelled by callers
  private final Set<String> defined = new HashSet<>();
  private final Map<String, XmlElement> used = new LinkedHashMap<>(); // by name, where first used
  private final Map<String, Double> given;

  /**
   * @param given values of the vehicle file, which override those of the aircraft's file
   */
  PropertyTree(Map<String, Double> given) {
    this.given = new HashMap<>();
    given.forEach((name, value) -> this.given.put(canonical(name), value));
    this.given.forEach(this::define);
  }

  private static String canonical(String name) {
    return name.trim().replace("[0]", "");
  }

  private Property find(String name) {
    return all.computeIfAbsent(canonical(name), unseen -> new Property());
  }

  /** A property set by this simulation, initially from the vehicle file or else as given. */
  Property define(String name, double value) {
    Property property = find(name);
    if (defined.add(canonical(name))) {
      property.value = given.getOrDefault(canonical(name), value);
    }
    return property;
  }

  /** Sets a property of the simulation. */
  void set(String name, double value) {
    Property known = quick.get(name);
    if (known == null) {
      known = define(name, value);
      quick.put(name, known);
    }
    known.value = value;
  }

  /** A property that an element of the file reads; a minus sign before its name negates it. */
  DoubleSupplier read(String name, XmlElement where) {
    String text = name.trim();
    boolean isNegated = text.startsWith("-");
    String plain = canonical(isNegated ? text.substring(1) : text);
    used.putIfAbsent(plain, where);
    Property property = find(plain);
    return isNegated ? () -> -property.value : () -> property.value;
  }

  /** Whether an element of the file reads it. */
  boolean isRead(String name) {
    return used.containsKey(canonical(name));
  }

  /** Whether a property exists. */
  boolean isDefined(String name) {
    return defined.contains(canonical(name));
  }

  /** Current value. */
  double get(String name) {
    return find(name).value;
  }

  /**
   * Call when everything is read.
   *
   * @throws org.u2sa.interfaces.BadInputException at the first property that nothing sets
   */
  void requireDefined() {
    for (Map.Entry<String, XmlElement> each : used.entrySet()) {
      if (!defined.contains(each.getKey())) {
        String folder = each.getKey().substring(0, each.getKey().indexOf('/') + 1);
        Set<String> near = new TreeSet<>(defined);
        near.removeIf(name -> !name.startsWith(folder));
        throw each.getValue()
            .error(
                "property \""
                    + each.getKey()
                    + "\" is never set; expected one of "
                    + String.join(", ", near)
                    + ", or a <property name=\""
                    + each.getKey()
                    + "\"> in the vehicle file");
      }
    }
  }
}
