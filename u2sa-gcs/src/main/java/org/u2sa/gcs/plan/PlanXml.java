package org.u2sa.gcs.plan;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.report.EscapedXml;

/** Imported goals and fences as the XML files of a vehicle. */
public final class PlanXml {
  private static final List<String> UNWRITTEN =
      List.of("uid", "repeatFrom", "repeatTimes", "completed", "abandoned", "referenceFrame");

  private PlanXml() {}

  /** A mission file (docs/missions.md). Each goal's name is its number. */
  public static String mission(Optional<StationPlan.Place> home, List<GoalInformation> goals) {
    StringBuilder text = new StringBuilder("<mission>\n");
    home.ifPresent(
        place -> {
          text.append("  <home>\n");
          element(text, "x", place.longitudeDeg());
          element(text, "y", place.latitudeDeg());
          place.altitudeM().ifPresent(altitude -> element(text, "z", altitude));
          text.append("  </home>\n");
        });
    for (GoalInformation goal : goals) {
      String name = goal.type().name();
      String tag = name.substring(0, 1).toLowerCase(Locale.ROOT) + name.substring(1);
      text.append("  <").append(tag).append(">\n");
      for (FieldValue field : goal.enumerateFields()) {
        if (!UNWRITTEN.contains(field.name())) {
          field.value().ifPresent(value -> field(text, field.name(), value));
        }
      }
      goal.repeatFrom()
          .ifPresent(
              from ->
                  text.append("    <repeat from=\"")
                      .append(EscapedXml.of(from))
                      .append("\" times=\"")
                      .append(goal.repeatTimes().orElse(1))
                      .append("\"/>\n"));
      text.append("  </").append(tag).append(">\n");
    }
    return text.append("</mission>\n").toString();
  }

  private static void field(StringBuilder text, String name, Object value) {
    if (value instanceof List<?> list) {
      if (!list.isEmpty()) {
        element(text, name, list.get(0)); // an item has one successor
      }
    } else if (value instanceof Point point) {
      element(text, name, point.x() + " " + point.y() + " " + point.z());
    } else {
      element(text, name, value);
    }
  }

  private static void element(StringBuilder text, String name, Object value) {
    text.append("    <").append(name).append('>');
    text.append(EscapedXml.of(String.valueOf(value)));
    text.append("</").append(name).append(">\n");
  }

  /**
   * A fence file (docs/health-and-failsafes.md).
   *
   * @param limits elements {@code <floor>} and {@code <ceiling>}
   * @param rally places to return to
   * @param lost receives areas that such a file cannot have
   */
  public static String fence(
      String limits,
      List<StationPlan.Area> areas,
      List<StationPlan.Place> rally,
      List<String> lost) {
    StringBuilder text = new StringBuilder("<fence>\n").append(limits);
    int kept = 0;
    for (StationPlan.Area area : areas) {
      boolean isCircle = area.radiusM().isPresent();
      if (area.isInclusion() && kept++ > 0) {
        lost.add("fence: a second " + (isCircle ? "circle" : "polygon") + " to stay within");
        continue;
      }
      String tag = area.isInclusion() ? "keepIn" : "keepOut";
      text.append("  <").append(tag).append(">\n");
      for (StationPlan.Place corner : area.corners()) {
        text.append("    <")
            .append(isCircle ? "centre" : "corner")
            .append("><x>")
            .append(corner.longitudeDeg())
            .append("</x><y>")
            .append(corner.latitudeDeg())
            .append("</y></")
            .append(isCircle ? "centre" : "corner")
            .append(">\n");
      }
      area.radiusM().ifPresent(radius -> element(text, "radius", radius));
      text.append("  </").append(tag).append(">\n");
    }
    for (StationPlan.Place place : rally) {
      text.append("  <rally>\n");
      element(text, "x", place.longitudeDeg());
      element(text, "y", place.latitudeDeg());
      place.altitudeM().ifPresent(altitude -> element(text, "z", altitude));
      text.append("  </rally>\n");
    }
    return text.append("</fence>\n").toString();
  }
}
