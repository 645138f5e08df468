package org.u2sa.sim.world;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.atmosphere.WindProfile;

/**
 * Reads the element {@code <environment>} of a world file: terrain, surface, water, wind and light.
 */
public final class EnvironmentElement {
  private static final Map<String, Supplier<Surface>> SURFACES =
      Map.of("lawn", Surface::lawn, "concrete", Surface::concrete, "field", Surface::field);
  private static final double SIGMA_PER_WIND = 0.1; // MIL-F-8785C, 3.7.3.2

  private EnvironmentElement() {}

  /**
   * Copy of a world with the settings of the element; others stay unchanged.
   *
   * @param folder folder of the files named by the element
   * @param seed seed of gusts and waves
   * @throws org.u2sa.interfaces.BadInputException naming file, line, element, value and what was
   *     expected
   */
  public static World apply(XmlElement element, World world, Path folder, long seed) {
    element.refuseUnknownAttributes();
    element.refuseText();
    element.refuseUnknownChildren("terrain", "surface", "water", "wind", "light");
    for (String name : List.of("terrain", "surface", "water", "wind", "light")) {
      element.child(name); // rejects a second one
    }
    World with = world;
    for (XmlElement child : element.children()) {
      try {
        with =
            switch (child.name()) {
              case "terrain" -> with.with(terrain(child, world.plane(), folder));
              case "surface" -> with.with(surface(child));
              case "water" -> with.with(water(child, seed));
              case "light" -> with.with(light(child));
              default -> with.with(wind(child, seed));
            };
      } catch (IllegalArgumentException e) {
        throw child.error(e.getMessage(), e);
      }
    }
    return with;
  }

  private static Terrain terrain(XmlElement element, LocalPlane plane, Path folder) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren("heights", "width", "depth", "lowest", "highest");
    XmlElement heights = ElementValues.required(element, "heights");
    if (GeoTiff.isNamed(heights.text())) {
      element.refuseUnknownChildren("heights", "width", "depth");
      return GeoTiff.read(
          path(heights, folder), plane, length(element, "width"), length(element, "depth"));
    }
    double width = length(element, "width");
    double depth = length(element, "depth");
    double lowest = length(element, "lowest");
    double highest = length(element, "highest");
    return HeightMap.read(path(heights, folder), width, depth, lowest, highest);
  }

  private static Path path(XmlElement element, Path folder) {
    try {
      Path file = folder.resolve(element.text()).normalize();
      if (file.startsWith(folder.normalize())
          && Files.exists(file)
          && !file.toRealPath().startsWith(folder.toRealPath())) {
        throw element.error(
            "\"" + element.text() + "\" is a link that leads out of " + folder.toAbsolutePath());
      }
      return file;
    } catch (IOException e) {
      throw element.error("\"" + element.text() + "\" cannot be read: " + e.getMessage(), e);
    } catch (InvalidPathException e) {
      throw element.error("\"" + element.text() + "\" is not a file name", e);
    }
  }

  static Surface surface(XmlElement element) {
    element.refuseUnknownAttributes();
    if (!element.children().isEmpty()) {
      element.refuseUnknownChildren("grip", "rollingResistance");
      return Surface.even(
          number(element, "grip", "", "").orElseThrow(() -> ElementValues.lacks(element, "grip")),
          number(element, "rollingResistance", "", "")
              .orElseThrow(() -> ElementValues.lacks(element, "rollingResistance")));
    }
    return Optional.ofNullable(SURFACES.get(element.text()))
        .orElseThrow(
            () ->
                element.error(
                    "\""
                        + element.text()
                        + "\" is not a surface; expected lawn, concrete or field, or <grip> and <rollingResistance>"))
        .get();
  }

  private static Water water(XmlElement element, long seed) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren("level", "current", "towards", "currents", "profile", "waves");
    double current = number(element, "current", "m/s", "m/s").orElse(0.0);
    double towards = number(element, "towards", "rad", "rad").orElse(0.0);
    Optional<XmlElement> grid = element.child("currents");
    if (grid.isPresent() && element.child("current").isPresent()) {
      throw grid.get().error("is given together with <current>; expected only one of them");
    }
    CurrentField field =
        grid.map(EnvironmentElement::currents)
            .orElseGet(
                () ->
                    CurrentField.uniform(
                        current * StrictMath.sin(towards), current * StrictMath.cos(towards)));
    return new Water(
        number(element, "level", "m", "m").orElse(0.0),
        element.child("profile").map(each -> profiled(field, each)).orElse(field),
        element.child("waves").map(each -> waves(each, seed)));
  }

  private static CurrentField currents(XmlElement element) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren("columns", "width", "depth", "east", "north");
    return CurrentField.grid(
        array(ElementValues.numbers(ElementValues.required(element, "east"), "m/s", -20.0, 20.0)),
        array(ElementValues.numbers(ElementValues.required(element, "north"), "m/s", -20.0, 20.0)),
        (int) ElementValues.number(element, "columns", "", 2.0, 4_096.0),
        length(element, "width"),
        length(element, "depth"));
  }

  private static CurrentField profiled(CurrentField field, XmlElement element) {
    List<Double> pairs = ElementValues.numbers(element, "", -2.0, 12_000.0);
    if (pairs.isEmpty() || pairs.size() % 2 != 0) {
      throw element.error(
          pairs.size() + " numbers; expected pairs of a depth in m and a share of the current");
    }
    double[] all = array(pairs);
    int count = all.length / 2;
    return field.withProfile(
        IntStream.range(0, count).mapToDouble(i -> all[2 * i]).toArray(),
        IntStream.range(0, count).mapToDouble(i -> all[2 * i + 1]).toArray());
  }

  private static double[] array(List<Double> values) {
    return values.stream().mapToDouble(Double::doubleValue).toArray();
  }

  private static Waves waves(XmlElement element, long seed) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren("spectrum", "height", "period", "towards", "spread");
    return Waves.of(
        ElementValues.choice(element, "spectrum", Waves.Spectrum.class, Waves.Spectrum.JONSWAP),
        ElementValues.number(element, "height", "m", 0.0, 30.0),
        ElementValues.number(element, "period", "s", 0.5, 30.0),
        number(element, "towards", "rad", "rad").orElse(0.0),
        ElementValues.number(element, "spread", "rad", 0.0, 1.0, 0.0),
        seed);
  }

  private static Sunlight light(XmlElement element) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren("azimuth", "elevation", "brightness", "direct");
    return new Sunlight(
        ElementValues.number(element, "azimuth", "rad", -7.0, 7.0),
        ElementValues.number(element, "elevation", "rad", 0.02, Math.PI / 2.0),
        ElementValues.number(element, "brightness", "", 0.0, 10.0, 1.0),
        ElementValues.number(element, "direct", "", 0.0, 1.0, 0.7));
  }

  private static Wind wind(XmlElement element, long seed) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren(
        "speed", "from", "gusts", "shear", "roughness", "exponent", "reference");
    double speed =
        number(element, "speed", "m/s", "m/s")
            .orElseThrow(() -> ElementValues.lacks(element, "speed"));
    double from = number(element, "from", "rad", "rad").orElse(0.0);
    double sigma = number(element, "gusts", "m/s", "m/s").orElse(SIGMA_PER_WIND * speed);
    return Wind.constant(from, speed).withGusts(sigma, seed).with(profile(element));
  }

  private static WindProfile profile(XmlElement element) {
    boolean isMilitary = ElementValues.flag(element, "shear");
    boolean isLog = element.child("roughness").isPresent();
    boolean isPower = element.child("exponent").isPresent();
    if ((isMilitary ? 1 : 0) + (isLog ? 1 : 0) + (isPower ? 1 : 0) > 1) {
      throw element.error("expected only one of <shear>, <roughness> and <exponent>");
    }
    double reference = ElementValues.number(element, "reference", "m", 0.1, 300.0, 10.0);
    if (isLog) {
      return WindProfile.logarithmic(
          ElementValues.number(element, "roughness", "m", 1e-5, 3.0), reference);
    } else if (isPower) {
      return WindProfile.power(ElementValues.number(element, "exponent", "", 0.0, 1.0), reference);
    } else if (element.child("reference").isPresent()) {
      throw element
          .child("reference")
          .get()
          .error("expected only together with <roughness> or <exponent>");
    }
    return isMilitary ? WindProfile.military() : WindProfile.uniform();
  }

  private static double length(XmlElement element, String name) {
    return XmlNumbers.converted(ElementValues.required(element, name), "m", "m");
  }

  private static Optional<Double> number(
      XmlElement element, String name, String ifUnset, String to) {
    return element.child(name).map(child -> XmlNumbers.converted(child, ifUnset, to));
  }
}
