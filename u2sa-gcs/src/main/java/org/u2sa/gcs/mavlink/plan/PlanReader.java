package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.gcs.plan.ItemGoals;
import org.u2sa.gcs.plan.PlanItem;
import org.u2sa.gcs.plan.PlanXml;
import org.u2sa.gcs.plan.StationPlan;
import org.u2sa.messages.frame.Geodetic;

/** Turns uploaded items into a mission that a kind of vehicle can carry out. */
final class PlanReader {
  private final VehicleKind kind;
  private final List<PlanItem> items = new ArrayList<>();
  private final List<String> details = new ArrayList<>();
  private final ItemGoals goals;
  private final Optional<StationPlan.Place> home;

  /**
   * @param home home position, for relative altitudes and for returning
   * @param uploaded items in order
   * @param first sequence number of the first
   * @throws PlanRefusal if an item cannot be expressed
   */
  PlanReader(VehicleKind kind, Optional<Geodetic> home, List<MissionItem> uploaded, int first) {
    this.kind = kind;
    this.home =
        home.map(
            place ->
                new StationPlan.Place(
                    place.longitudeDeg(),
                    place.latitudeDeg(),
                    OptionalDouble.of(place.altitudeM())));
    for (int i = 0; i < uploaded.size(); i++) {
      PlanItem item = uploaded.get(i).planItem(i + 1, first);
      items.add(suited(item));
    }
    List<String> lost = new ArrayList<>();
    goals = goals(new StationPlan(this.home, items, List.of()), lost, details);
    if (!lost.isEmpty()) {
      throw new PlanRefusal(
          MavMissionResult.MAV_MISSION_UNSUPPORTED, "mission " + PlanRefusal.some(lost));
    }
    if (goals.goals().isEmpty()) {
      throw new PlanRefusal(
          MavMissionResult.MAV_MISSION_INVALID,
          "the mission has no waypoint; expected at least one");
    }
  }

  private static ItemGoals goals(StationPlan plan, List<String> lost, List<String> details) {
    try {
      return ItemGoals.of(plan, lost, details);
    } catch (IllegalArgumentException e) { // names field, value and range
      throw new PlanRefusal(MavMissionResult.MAV_MISSION_INVALID, "mission: " + e.getMessage());
    }
  }

  /** The mission in XML (docs/missions.md). */
  String xml() {
    return PlanXml.mission(home, goals.goals()).replaceAll(">\\s+<", "><");
  }

  /** Name of the goal of each item, as {@link MissionPlan#goals}. */
  List<String> names() {
    return goals.names();
  }

  /** Parameters left out, one line each. */
  List<String> details() {
    return details;
  }

  private PlanItem suited(PlanItem item) {
    if (item.isOrder() || item.isView()) {
      return item;
    }
    if (kind.isOnSurface()) {
      if (item.command() == PlanItem.TAKE_OFF || item.command() == PlanItem.LAND) {
        throw refusal(item, "this vehicle neither takes off nor lands");
      }
      item = item.with(PlanItem.PARAMETERS, Double.NaN); // its altitude is the surface's
    }
    if (kind != VehicleKind.PLANE && item.command() == PlanItem.LOITER_TURNS) {
      throw refusal(item, "this vehicle stays in place; it does not fly turns");
    }
    return item;
  }

  private static PlanRefusal refusal(PlanItem item, String why) {
    return new PlanRefusal(
        MavMissionResult.MAV_MISSION_UNSUPPORTED, "mission " + item.title() + ": " + why);
  }
}
