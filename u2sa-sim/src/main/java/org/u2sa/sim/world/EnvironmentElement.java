package org.u2sa.sim.world;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.sim.atmosphere.Wind;

/** Reads the element {@code <environment>} of a world file: terrain, surface, water and wind. */
public final class EnvironmentElement {
  private static final Map<String, Supplier<Surface>> SURFACES =
      Map.of("lawn", Surface::lawn, "concrete", Surface::concrete, "field", Surface::field);
  private static final double SIGMA_PER_WIND = 0.1; // MIL-F-8785C, 3.7.3.2

  private EnvironmentElement() {}

  /**
   * A world with what the element describes; what it does not mention stays as it is.
   *
   * @param folder where files are that the element names
   * @param seed seed of the gusts
   * @throws org.u2sa.interfaces.BadInputException naming file, line, element, value and what was
   *     expected
   */
  public static World apply(XmlElement element, World world, Path folder, long seed) {
    element.refuseUnknownAttributes();
    element.refuseText();
    element.refuseUnknownChildren("terrain", "surface", "water", "wind");
    World with = world;
    for (XmlElement child : element.children()) {
      try {
        with =
            switch (child.name()) {
              case "terrain" -> with.with(terrain(child, folder));
              case "surface" -> with.with(surface(child));
              case "water" -> with.with(water(child));
              default -> with.with(wind(child, seed));
            };
      } catch (IllegalArgumentException e) {
        throw child.error(e.getMessage(), e);
      }
    }
    return with;
  }

  private static Terrain terrain(XmlElement element, Path folder) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren("heights", "width", "depth", "lowest", "highest");
    XmlElement heights = required(element, "heights");
    double width = length(element, "width");
    double depth = length(element, "depth");
    double lowest = length(element, "lowest");
    double highest = length(element, "highest");
    return HeightMap.read(folder.resolve(heights.text()), width, depth, lowest, highest);
  }

  private static Surface surface(XmlElement element) {
    element.refuseUnknownAttributes();
    if (!element.children().isEmpty()) {
      element.refuseUnknownChildren("grip", "rollingResistance");
      return Surface.even(
          number(element, "grip", "", "").orElseThrow(() -> lacks(element, "grip")),
          number(element, "rollingResistance", "", "")
              .orElseThrow(() -> lacks(element, "rollingResistance")));
    }
    return Optional.ofNullable(SURFACES.get(element.text()))
        .orElseThrow(
            () ->
                element.error(
                    "\""
                        + element.text()
                        + "\" is no surface; expected lawn, concrete or field, or <grip> and <rollingResistance>"))
        .get();
  }

  private static Water water(XmlElement element) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren("level", "current", "towards");
    double current = number(element, "current", "m/s", "m/s").orElse(0.0);
    double towards = number(element, "towards", "rad", "rad").orElse(0.0);
    return new Water(
        number(element, "level", "m", "m").orElse(0.0),
        current * StrictMath.sin(towards),
        current * StrictMath.cos(towards));
  }

  private static Wind wind(XmlElement element, long seed) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren("speed", "from", "gusts", "shear");
    double speed =
        number(element, "speed", "m/s", "m/s").orElseThrow(() -> lacks(element, "speed"));
    double from = number(element, "from", "rad", "rad").orElse(0.0);
    double sigma = number(element, "gusts", "m/s", "m/s").orElse(SIGMA_PER_WIND * speed);
    return Wind.constant(from, speed).withGusts(sigma, seed).withShear(flag(element, "shear"));
  }

  private static boolean flag(XmlElement element, String name) {
    Optional<XmlElement> child = element.child(name);
    if (child.isPresent() && !child.get().text().matches("true|false")) {
      throw child.get().error("\"" + child.get().text() + "\": expected true or false");
    }
    return child.isPresent() && child.get().text().equals("true");
  }

  private static double length(XmlElement element, String name) {
    return XmlNumbers.converted(required(element, name), "m", "m");
  }

  private static Optional<Double> number(
      XmlElement element, String name, String ifUnset, String to) {
    return element.child(name).map(child -> XmlNumbers.converted(child, ifUnset, to));
  }

  private static XmlElement required(XmlElement element, String name) {
    return element.child(name).orElseThrow(() -> lacks(element, name));
  }

  private static RuntimeException lacks(XmlElement element, String name) {
    return element.error("lacks <" + name + ">");
  }
}
