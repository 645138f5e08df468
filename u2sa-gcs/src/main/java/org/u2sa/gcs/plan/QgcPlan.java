package org.u2sa.gcs.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.JsonText;
import org.u2sa.report.message.JsonReader;

/**
 * QGroundControl's {@code .plan}, version 1
 * (docs.qgroundcontrol.com/master/en/qgc-dev-guide/file_formats/plan.html).
 */
public final class QgcPlan {
  private static final int GENERIC = 0; // MAV_AUTOPILOT_GENERIC, MAV_TYPE_GENERIC
  private static final double SPEED_MPS = 5.0; // only for the station's estimate of the duration
  private static final String VERSION = "version";
  private static final String ITEMS = "items";
  private static final String CIRCLES = "circles";
  private static final String POLYGONS = "polygons";

  private final String origin;
  private final List<String> lost;

  private QgcPlan(String origin, List<String> lost) {
    this.origin = origin;
    this.lost = lost;
  }

  /**
   * Reads a plan.
   *
   * @param origin name of the file, for errors
   * @param lost receives what cannot be expressed here, one line each
   * @throws BadInputException naming the field
   */
  public static StationPlan read(String origin, String text, List<String> lost) {
    return new QgcPlan(origin, lost).plan(JsonReader.object(origin, text));
  }

  private StationPlan plan(Map<String, Object> json) {
    if (!"Plan".equals(json.get("fileType"))) {
      throw wrong("fileType: expected \"Plan\"");
    }
    Map<?, ?> mission = map(json.get("mission"), "mission");
    List<PlanItem> items = new ArrayList<>();
    for (Object each : list(mission.get(ITEMS), "mission.items")) {
      item(map(each, "mission.items"), items.size()).ifPresent(items::add);
    }
    List<StationPlan.Area> areas = new ArrayList<>();
    if (json.get("geoFence") instanceof Map<?, ?> fence) {
      areas(fence, areas);
    }
    Optional<StationPlan.Place> home = Optional.empty();
    if (mission.get("plannedHomePosition") instanceof List<?> place) {
      home = Optional.of(place(place, "plannedHomePosition"));
    }
    List<StationPlan.Place> rally = new ArrayList<>();
    if (json.get("rallyPoints") instanceof Map<?, ?> points
        && points.get("points") instanceof List<?> places) {
      for (Object each : places) {
        rally.add(aboveSeaLevel(place(each, "rallyPoints.points"), home));
      }
    }
    return new StationPlan(home, items, areas, rally);
  }

  /** A rally point, whose altitude is relative to home in plans. */
  private StationPlan.Place aboveSeaLevel(
      StationPlan.Place point, Optional<StationPlan.Place> home) {
    OptionalDouble homeM = home.map(StationPlan.Place::altitudeM).orElse(OptionalDouble.empty());
    if (point.altitudeM().isEmpty()) {
      return point;
    }
    if (homeM.isEmpty()) {
      lost.add("rally point: its altitude, because the home's is not known");
    }
    return new StationPlan.Place(
        point.longitudeDeg(),
        point.latitudeDeg(),
        homeM.isEmpty()
            ? homeM
            : OptionalDouble.of(point.altitudeM().getAsDouble() + homeM.getAsDouble()));
  }

  private Optional<PlanItem> item(Map<?, ?> json, int before) {
    String where = "mission.items[" + before + "]";
    if (!"SimpleItem".equals(json.get("type"))) {
      Object kind = json.get("complexItemType");
      lost.add(where + ": a " + (kind == null ? json.get("type") : kind) + " is not one item");
      return Optional.empty();
    }
    List<?> given = list(json.get("params"), where + ".params");
    if (given.size() != PlanItem.PARAMETERS) {
      throw wrong(where + ".params: " + given.size() + " numbers; expected 7");
    }
    List<Double> parameters = new ArrayList<>();
    for (Object each : given) {
      parameters.add(each instanceof Optional ? Double.NaN : number(each, where + ".params"));
    }
    Object id = json.get("doJumpId");
    return Optional.of(
        new PlanItem(
            (int) number(json.get("command"), where + ".command"),
            (int) number(json.get("frame"), where + ".frame"),
            parameters,
            !Boolean.FALSE.equals(json.get("autoContinue")),
            id == null ? before + 1 : (int) number(id, where + ".doJumpId")));
  }

  private void areas(Map<?, ?> fence, List<StationPlan.Area> areas) {
    if (fence.get(POLYGONS) instanceof List<?> polygons) {
      for (Object each : polygons) {
        Map<?, ?> polygon = map(each, "geoFence.polygons");
        List<StationPlan.Place> corners = new ArrayList<>();
        for (Object corner : list(polygon.get("polygon"), "geoFence.polygons.polygon")) {
          corners.add(place(corner, "geoFence.polygons.polygon"));
        }
        areas.add(new StationPlan.Area(isInclusion(polygon), corners, OptionalDouble.empty()));
      }
    }
    if (fence.get(CIRCLES) instanceof List<?> circles) {
      for (Object each : circles) {
        Map<?, ?> json = map(each, "geoFence.circles");
        Map<?, ?> circle = map(json.get("circle"), "geoFence.circles.circle");
        StationPlan.Place centre = place(circle.get("center"), "geoFence.circles.circle.center");
        double radius = number(circle.get("radius"), "geoFence.circles.circle.radius");
        if (!(radius > 0.0)) {
          throw wrong("geoFence.circles.circle.radius: " + radius + "; expected more than 0 m");
        }
        areas.add(
            new StationPlan.Area(isInclusion(json), List.of(centre), OptionalDouble.of(radius)));
      }
    }
  }

  private static boolean isInclusion(Map<?, ?> area) {
    return !Boolean.FALSE.equals(area.get("inclusion"));
  }

  private StationPlan.Place place(Object json, String where) {
    List<?> numbers = list(json, where);
    if (numbers.size() < 2) {
      throw wrong(where + ": expected [latitude, longitude]");
    }
    double latitude = number(numbers.get(0), where);
    double longitude = number(numbers.get(1), where);
    if (!(Math.abs(latitude) <= 90.0 && Math.abs(longitude) <= 180.0)) {
      throw wrong(where + ": " + latitude + ", " + longitude + " is not on the earth");
    }
    boolean hasAltitude = numbers.size() > 2 && numbers.get(2) instanceof Number;
    return new StationPlan.Place(
        longitude,
        latitude,
        hasAltitude ? OptionalDouble.of(number(numbers.get(2), where)) : OptionalDouble.empty());
  }

  private double number(Object value, String where) {
    if (value instanceof Number number) {
      return number.doubleValue();
    }
    throw wrong(where + ": expected a number");
  }

  private List<?> list(Object value, String where) {
    if (value instanceof List<?> list) {
      return list;
    }
    throw wrong(where + ": expected a list");
  }

  private Map<?, ?> map(Object value, String where) {
    if (value instanceof Map<?, ?> map) {
      return map;
    }
    throw wrong(where + ": expected an object");
  }

  private BadInputException wrong(String what) {
    return new BadInputException(origin + ": " + what);
  }

  /** Writes a plan. */
  public static String text(StationPlan plan) {
    List<Object> polygons = new ArrayList<>();
    List<Object> circles = new ArrayList<>();
    for (StationPlan.Area area : plan.areas()) {
      JsonText json = new JsonText().put("inclusion", area.isInclusion()).put(VERSION, 1);
      if (area.radiusM().isPresent()) {
        JsonText circle =
            new JsonText()
                .put("center", corner(area.corners().get(0)))
                .put("radius", area.radiusM().getAsDouble());
        circles.add(json.put("circle", circle));
      } else {
        polygons.add(json.put("polygon", area.corners().stream().map(QgcPlan::corner).toList()));
      }
    }
    JsonText mission =
        new JsonText()
            .put("cruiseSpeed", SPEED_MPS)
            .put("hoverSpeed", SPEED_MPS)
            .put("firmwareType", GENERIC)
            .put("vehicleType", GENERIC)
            .put(ITEMS, plan.items().stream().map(QgcPlan::json).toList());
    StationPlan.Place home = plan.home().orElse(null);
    if (home == null) {
      mission.putNull("plannedHomePosition");
    } else {
      List<Object> position = new ArrayList<>(corner(home));
      position.add(home.altitudeM().orElse(0.0));
      mission.put("plannedHomePosition", position);
    }
    return new JsonText()
        .put("fileType", "Plan")
        .put("groundStation", "U2SA")
        .put(VERSION, 1)
        .put("mission", mission.put(VERSION, 2))
        .put(
            "geoFence",
            new JsonText().put(CIRCLES, circles).put(POLYGONS, polygons).put(VERSION, 2))
        .put("rallyPoints", new JsonText().put("points", rally(plan)).put(VERSION, 2))
        .toString();
  }

  private static List<Object> rally(StationPlan plan) {
    double homeM =
        plan.home().map(StationPlan.Place::altitudeM).orElse(OptionalDouble.empty()).orElse(0.0);
    List<Object> points = new ArrayList<>();
    for (StationPlan.Place place : plan.rally()) {
      List<Object> point = new ArrayList<>(corner(place));
      point.add(place.altitudeM().orElse(homeM) - homeM);
      points.add(point);
    }
    return points;
  }

  private static List<Object> corner(StationPlan.Place place) {
    return List.of(place.latitudeDeg(), place.longitudeDeg());
  }

  private static JsonText json(PlanItem item) {
    List<Object> parameters = new ArrayList<>();
    item.parameters().forEach(each -> parameters.add(each.isNaN() ? null : each));
    JsonText json =
        new JsonText()
            .put("type", "SimpleItem")
            .put("command", item.command())
            .put("frame", item.frame())
            .put("params", parameters)
            .put("autoContinue", item.goesOn())
            .put("doJumpId", item.id());
    if (item.frame() != PlanItem.MISSION) {
      double altitude = item.parameter(PlanItem.PARAMETERS);
      json.put("AltitudeMode", 2); // absolute
      if (Double.isNaN(altitude)) {
        json.putNull("Altitude");
      } else {
        json.put("Altitude", altitude);
      }
    }
    return json;
  }
}
