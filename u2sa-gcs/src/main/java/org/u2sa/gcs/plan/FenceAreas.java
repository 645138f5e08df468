package org.u2sa.gcs.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;

/** Reads a fence file (docs/health-and-failsafes.md) as areas of a plan. */
public final class FenceAreas {
  private static final String CENTRE = "centre";

  private FenceAreas() {}

  /**
   * Areas of an element {@code <fence>}, in its order.
   *
   * @param lost receives what areas cannot express, one line each
   * @throws org.u2sa.interfaces.BadInputException naming file, line and element
   */
  public static List<StationPlan.Area> read(XmlElement root, List<String> lost) {
    root.refuseUnknownChildren("reference", "floor", "ceiling", "keepIn", "keepOut", "rally");
    root.child("reference")
        .filter(reference -> !reference.text().equalsIgnoreCase("Global"))
        .ifPresent(
            reference -> {
              throw reference.error("\"" + reference.text() + "\": plans support Global only");
            });
    for (String limit : List.of("floor", "ceiling")) {
      root.child(limit).ifPresent(each -> lost.add("fence: its " + limit + " " + each.text()));
    }
    List<StationPlan.Area> areas = new ArrayList<>();
    for (XmlElement child : root.children()) {
      if (child.name().startsWith("keep")) {
        areas.add(area(child));
      }
    }
    return areas;
  }

  /** Rally points of an element {@code <fence>}. */
  public static List<StationPlan.Place> rally(XmlElement root) {
    return root.children("rally").stream()
        .map(
            each ->
                new StationPlan.Place(
                    number(each, "x"),
                    number(each, "y"),
                    each.child("z").stream()
                        .mapToDouble(z -> XmlNumbers.converted(z, "m", "m"))
                        .findFirst()))
        .toList();
  }

  private static StationPlan.Area area(XmlElement element) {
    List<StationPlan.Place> corners = new ArrayList<>();
    for (XmlElement corner : element.children()) {
      if (corner.name().equals("corner") || corner.name().equals(CENTRE)) {
        corners.add(
            new StationPlan.Place(
                number(corner, "x"), number(corner, "y"), OptionalDouble.empty()));
      }
    }
    OptionalDouble radius =
        element.child(CENTRE).isPresent()
            ? OptionalDouble.of(XmlNumbers.converted(element.requiredChild("radius"), "m", "m"))
            : OptionalDouble.empty();
    return new StationPlan.Area(element.name().equals("keepIn"), corners, radius);
  }

  private static double number(XmlElement place, String name) {
    return XmlNumbers.converted(place.requiredChild(name), "deg", "deg");
  }
}
