package org.u2sa.scenarios.vrx;

import static org.u2sa.scenarios.vrx.SdfValues.number;
import static org.u2sa.scenarios.vrx.SdfValues.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.marine.Colour;

/** Reads dock and light buoy of a world. */
final class DockingReader {
  private DockingReader() {}

  static Docking read(XmlElement world, VrxObjects objects, XmlElement scoring) {
    VrxObjects.Included dock =
        objects.first("dock").orElseThrow(() -> world.error("includes no dock"));
    VrxObjects.Included light =
        objects.first("robotx_light").orElseThrow(() -> world.error("includes no light buoy"));
    List<Docking.Bay> bays = new ArrayList<>();
    double stayS = 0.0;
    for (XmlElement bay : scoring.requiredChild("bays").children("bay")) {
      String[] sign = text(bay, "symbol").split("_");
      bays.add(
          new Docking.Bay(
              colour(bay.requiredChild("symbol"), sign[0]),
              sign[sign.length - 1],
              text(bay, "correct_dock").equalsIgnoreCase("true")));
      stayS = number(bay, "min_dock_time");
    }
    List<Colour> sequence = new ArrayList<>();
    for (String name : List.of("color_1", "color_2", "color_3")) {
      XmlElement each = scoring.requiredChild(name);
      sequence.add(colour(each, each.text().trim()));
    }
    return new Docking(
        dock.place(),
        dock.yawRad(),
        bays,
        sequence,
        light.place(),
        new Docking.Points(
            number(scoring, "color_bonus_points", 10.0),
            number(scoring, "dock_bonus_points", 10.0),
            number(scoring, "correct_dock_bonus_points", 10.0)),
        stayS);
  }

  private static Colour colour(XmlElement element, String name) {
    return Arrays.stream(Colour.values())
        .filter(each -> each.name().equalsIgnoreCase(name))
        .findFirst()
        .orElseThrow(() -> element.error("\"" + name + "\": expected red, green, blue or yellow"));
  }
}
