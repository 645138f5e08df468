package org.u2sa.sim.file.element;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.xml.XmlElement;

/** Replaces values of a vehicle file, each identified by its element path. */
public final class VehicleChanges {
  private VehicleChanges() {}

  /**
   * A copy with other values.
   *
   * @param changes values by paths such as {@code body/mass}; an attribute is {@code gps/@preset}
   * @throws org.u2sa.interfaces.BadInputException if an element of the path does not exist; the
   *     last one may be new
   */
  public static XmlElement apply(XmlElement root, Map<String, String> changes) {
    XmlElement changed = root;
    for (Map.Entry<String, String> change : changes.entrySet()) {
      changed = set(changed, Arrays.asList(change.getKey().split("/")), change.getValue());
    }
    return changed;
  }

  private static XmlElement set(XmlElement element, List<String> path, String value) {
    String name = path.get(0);
    if (name.startsWith("@")) {
      Map<String, String> attributes = new LinkedHashMap<>(element.attributes());
      attributes.put(name.substring(1), value);
      return element.with(attributes, element.children(), element.text());
    }
    List<XmlElement> children = new ArrayList<>();
    boolean isFound = false;
    for (XmlElement child : element.children()) {
      boolean isMeant = !isFound && child.name().equals(name);
      isFound |= isMeant;
      children.add(isMeant ? changed(child, path, value) : child);
    }
    if (!isFound && path.size() > 1) {
      throw element.error(
          "has no <" + name + ">, which a change of \"" + String.join("/", path) + "\" needs");
    }
    if (!isFound) {
      children.add(
          new XmlElement(
              element.origin(), name, element.line(), element.span(), Map.of(), List.of(), value));
    }
    return element.with(element.attributes(), children, element.text());
  }

  private static XmlElement changed(XmlElement child, List<String> path, String value) {
    return path.size() > 1
        ? set(child, path.subList(1, path.size()), value)
        : child.with(child.attributes(), child.children(), value);
  }
}
