package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.u2sa.gcs.mavlink.telemetry.Placement;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.gcs.plan.GoalItems;
import org.u2sa.gcs.plan.PlanItem;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionReport;

/** Turns the Mission Manager's goals into items for download. */
final class PlanWriter {
  private PlanWriter() {}

  /** Goals in order, without those that orders have added. */
  static List<GoalInformation> goals(MissionReport report) {
    Map<String, GoalInformation> byName = new LinkedHashMap<>();
    report.goals().forEach(goal -> byName.put(goal.uid(), goal));
    List<GoalInformation> goals = new ArrayList<>();
    boolean isLinked = report.sequence().isEmpty();
    for (String uid : isLinked ? byName.keySet() : report.sequence()) {
      boolean isMission =
          !uid.equals(VehicleStatus.HOME)
              && !VehicleStatus.isGoTo(uid)
              && !uid.startsWith(VehicleStatus.LAND_PREFIX)
              && !uid.startsWith(VehicleStatus.RETURN_PREFIX);
      if (isMission && byName.containsKey(uid)) {
        goals.add(byName.get(uid));
      }
    }
    return goals;
  }

  /**
   * The items.
   *
   * @param first sequence number of the first
   * @throws PlanRefusal naming what items cannot express
   */
  static MissionPlan plan(MissionReport report, VehicleKind kind, int first) {
    List<GoalInformation> goals =
        goals(report).stream().map(PlanWriter::onTheEarth).collect(Collectors.toList());
    if (goals.isEmpty()) {
      return new MissionPlan(report.mission(), List.of(), List.of());
    }
    List<String> lost = new ArrayList<>();
    GoalItems made = GoalItems.of(goals, lost, new ArrayList<>());
    if (!lost.isEmpty()) {
      throw new PlanRefusal(MavMissionResult.MAV_MISSION_UNSUPPORTED, PlanRefusal.some(lost));
    }
    List<MissionItem> items =
        made.items().stream()
            .map(item -> MissionItem.of(kind.isOnSurface() ? level(item) : item, first))
            .collect(Collectors.toList());
    return new MissionPlan(report.mission(), items, made.names());
  }

  private static GoalInformation onTheEarth(GoalInformation goal) {
    if (!(goal instanceof Waypoint waypoint) || Placement.place(waypoint).isEmpty()) {
      return goal;
    }
    return waypoint
        .copy()
        .referenceFrame(ReferenceFrame.GLOBAL)
        .x(Placement.place(waypoint).get().longitudeDeg())
        .y(Placement.place(waypoint).get().latitudeDeg());
  }

  /** Stations expect an altitude even of vehicles on the ground. */
  private static PlanItem level(PlanItem item) {
    return item.isOrder() || item.isView()
        ? item
        : new PlanItem(
            item.command(),
            PlanItem.RELATIVE,
            item.with(PlanItem.PARAMETERS, 0.0).parameters(),
            item.goesOn(),
            item.id());
  }
}
