package org.u2sa.world.sdf;

import java.util.HashMap;
import java.util.Map;
import org.u2sa.interfaces.xml.XmlElement;

/** Finds the elements that COLLADA files refer to by {@code #id}. */
final class ColladaIds {
  private final Map<String, XmlElement> elements = new HashMap<>();

  ColladaIds(XmlElement root) {
    add(root);
  }

  private void add(XmlElement element) {
    element.optionalAttribute("id").ifPresent(id -> elements.putIfAbsent(id, element));
    element.children().forEach(this::add);
  }

  /**
   * The element that an attribute refers to.
   *
   * @throws org.u2sa.interfaces.BadInputException unless it is there and has this name
   */
  XmlElement target(XmlElement from, String attribute, String name) {
    String url = from.attribute(attribute);
    XmlElement found = url.startsWith("#") ? elements.get(url.substring(1)) : null;
    if (found == null || !found.name().equals(name)) {
      throw from.error(
          attribute + "=\"" + url + "\": expected # and the id of a <" + name + "> in this file");
    }
    return found;
  }
}
