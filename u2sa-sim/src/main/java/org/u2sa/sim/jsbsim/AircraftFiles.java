package org.u2sa.sim.jsbsim;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlText;
import org.u2sa.sim.flight.UnmannedAircraft;

/** An aircraft file and the files of its engines, propellers and systems. Immutable. */
final class AircraftFiles {
  private static final List<String> IGNORED = List.of("autopilot", "output", "input");
  private static final List<String> KNOWN =
      List.of(
          "fileheader",
          "metrics",
          "mass_balance",
          "ground_reactions",
          "external_reactions",
          "propulsion",
          "system",
          "flight_control",
          "aerodynamics",
          "autopilot",
          "output",
          "input");
  private static final List<String> BESIDE =
      List.of("", "Engines", "engine", "Systems", "../engine", "../../engine", "../../systems");

  /** Each may be evaluated in every tick; JSBSim's aircraft files have up to 1,300. */
  private static final int MAX_ELEMENTS = 20_000;

  private final Path folder;
  private final XmlElement aircraft;
  private final XmlElement propulsion;
  private final List<XmlElement> systems = new ArrayList<>();
  private final Map<String, XmlElement> parts = new TreeMap<>(); // by kind and name

  AircraftFiles(Path file) {
    folder = Optional.ofNullable(file.toAbsolutePath().getParent()).orElseThrow();
    aircraft = XmlText.read(file).root("fdm_config");
    aircraft.refuseUnknownChildren(KNOWN.toArray(new String[0]));
    propulsion =
        aircraft
            .child("propulsion")
            .orElse(
                new XmlElement(
                    aircraft.origin(),
                    "propulsion",
                    aircraft.line(),
                    aircraft.span(),
                    Map.of(),
                    List.of(),
                    ""));
    propulsion.refuseUnknownChildren("engine tank description documentation".split(" "));
    for (XmlElement tank : propulsion.children("tank")) {
      tank.refuseUnknownChildren(
          ("location drain_location capacity contents temperature density standpipe "
                  + "priority unusable-volume radius description")
              .split(" "));
    }
    for (XmlElement engine : propulsion.children("engine")) {
      XmlElement thruster = engine.requiredChild("thruster");
      load(engine, "piston_engine", "electric_engine");
      load(thruster, "propeller");
    }
    for (XmlElement each : aircraft.children()) {
      if (each.name().equals("system") || each.name().equals("flight_control")) {
        systems.add(each.attributes().containsKey("file") ? load(each, each.name()) : each);
      }
    }
    requireFewElements();
  }

  private void requireFewElements() {
    Deque<XmlElement> left = new ArrayDeque<>(parts.values());
    left.add(aircraft);
    int count = 0;
    while (!left.isEmpty()) {
      left.addAll(left.remove().children());
      count++;
    }
    if (count > MAX_ELEMENTS) {
      throw aircraft.error(
          count
              + " elements with engines and systems; expected at most "
              + MAX_ELEMENTS
              + ", which are evaluated "
              + UnmannedAircraft.TICKS_PER_SECOND
              + " times a second");
    }
  }

  /** Reads the file named by an element; its root must be one of these. */
  private XmlElement load(XmlElement element, String... roots) {
    String name = element.attribute("file");
    for (String beside : BESIDE) {
      for (String suffix : List.of("", ".xml")) {
        Path path = folder.resolve(beside).resolve(name + suffix).normalize();
        if (Files.isRegularFile(path)) {
          XmlText text = XmlText.read(path);
          String content = new String(text.bytes(), StandardCharsets.UTF_8);
          String root = roots[0];
          for (String each : roots) {
            root = content.contains("<" + each) ? each : root;
          }
          XmlElement read = text.root(root);
          parts.put(element.name() + " " + name, read);
          return read;
        }
      }
    }
    throw element.error(
        "file \""
            + name
            + "\" is missing; expected it in "
            + folder
            + " or its folders "
            + String.join(", ", BESIDE.subList(1, BESIDE.size())));
  }

  /**
   * A required part of the aircraft.
   *
   * @throws BadInputException if it is missing
   */
  XmlElement section(String name) {
    return aircraft.requiredChild(name);
  }

  XmlElement propulsion() {
    return propulsion;
  }

  XmlElement engine(XmlElement engine) {
    return parts.get("engine " + engine.attribute("file"));
  }

  XmlElement propeller(XmlElement engine) {
    return parts.get("thruster " + engine.child("thruster").orElseThrow().attribute("file"));
  }

  /** Systems and flight controls in the order of the file. */
  List<XmlElement> systems() {
    return systems;
  }

  /** Elements of the aircraft that have no effect. */
  List<String> ignored() {
    List<String> ignored = new ArrayList<>();
    for (XmlElement each : aircraft.children()) {
      if (IGNORED.contains(each.name()) || each.name().equals("external_reactions")) {
        ignored.add(each.toString());
      }
    }
    return ignored;
  }
}
