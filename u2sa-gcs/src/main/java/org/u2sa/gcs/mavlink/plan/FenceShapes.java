package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.gcs.plan.StationPlan;

/** Areas of a fence as items and back (mavlink.io/en/services/mission, geofence). */
final class FenceShapes {
  private static final int POLYGON_IN = 5001; // MAV_CMD_NAV_FENCE_…
  private static final int POLYGON_OUT = 5002;
  private static final int CIRCLE_IN = 5003;
  private static final int CIRCLE_OUT = 5004;
  private static final int GLOBAL = 0; // MAV_FRAME
  private static final Set<Integer> ON_EARTH =
      Set.of(0, 3, 5, 6); // MAV_FRAME_GLOBAL…; a fence's z does not count
  private static final double PER_DEGREE = 1.0e7;

  private FenceShapes() {}

  /**
   * Areas represented by items.
   *
   * @throws PlanRefusal naming an item that is not an area, or does not fit the others
   */
  static List<StationPlan.Area> areas(List<MissionItem> items) {
    List<StationPlan.Area> areas = new ArrayList<>();
    for (int i = 0; i < items.size(); ) {
      MissionItem first = items.get(i);
      boolean isCircle = first.command() == CIRCLE_IN || first.command() == CIRCLE_OUT;
      int count = isCircle ? 1 : corners(items, i);
      List<StationPlan.Place> places = new ArrayList<>();
      for (int k = i; k < i + count; k++) {
        places.add(place(items.get(k), k));
      }
      boolean isInclusion = first.command() == POLYGON_IN || first.command() == CIRCLE_IN;
      areas.add(
          new StationPlan.Area(
              isInclusion,
              places,
              isCircle
                  ? OptionalDouble.of(Double.parseDouble(Float.toString(first.param1())))
                  : OptionalDouble.empty()));
      i += count;
    }
    return areas;
  }

  /** Number of corners of the polygon that begins with an item. */
  private static int corners(List<MissionItem> items, int from) {
    MissionItem first = items.get(from);
    if (first.command() != POLYGON_IN && first.command() != POLYGON_OUT) {
      throw refusal(
          from,
          "is a command " + first.command() + "; expected 5001 to 5004, polygons and circles");
    }
    int count = (int) first.param1();
    if (count < 3 || count != first.param1() || count > items.size() - from) {
      throw refusal(
          from,
          "begins a polygon of "
              + first.param1()
              + " corners; expected at least 3, all among the items");
    }
    for (int k = from; k < from + count; k++) {
      MissionItem item = items.get(k);
      if (item.command() != first.command() || item.param1() != first.param1()) {
        throw refusal(k, "does not belong to the polygon that item " + (from + 1) + " starts");
      }
    }
    return count;
  }

  private static StationPlan.Place place(MissionItem item, int index) {
    if (!ON_EARTH.contains(item.frame())) {
      throw refusal(index, "is in MAV_FRAME " + item.frame() + "; expected MAV_FRAME_GLOBAL");
    }
    return new StationPlan.Place(item.longitudeDeg(), item.latitudeDeg(), OptionalDouble.empty());
  }

  private static PlanRefusal refusal(int index, String why) {
    return new PlanRefusal(
        MavMissionResult.MAV_MISSION_UNSUPPORTED, "fence item " + (index + 1) + ": " + why);
  }

  static List<MissionItem> items(List<StationPlan.Area> areas) {
    List<MissionItem> items = new ArrayList<>();
    for (StationPlan.Area area : areas) {
      boolean isCircle = area.radiusM().isPresent();
      int command =
          area.isInclusion()
              ? isCircle ? CIRCLE_IN : POLYGON_IN
              : isCircle ? CIRCLE_OUT : POLYGON_OUT;
      double param1 = area.radiusM().orElse(area.corners().size());
      for (StationPlan.Place place : area.corners()) {
        items.add(
            new MissionItem(
                GLOBAL,
                command,
                1,
                (float) param1,
                0.0f,
                0.0f,
                0.0f,
                (int) Math.round(place.latitudeDeg() * PER_DEGREE),
                (int) Math.round(place.longitudeDeg() * PER_DEGREE),
                0.0f));
      }
    }
    return items;
  }
}
