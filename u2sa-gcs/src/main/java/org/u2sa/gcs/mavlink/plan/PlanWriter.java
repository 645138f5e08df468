package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.gcs.mavlink.telemetry.Placement;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionReport;

/** Turns the Mission Manager's goals into items for download. */
final class PlanWriter {
  private static final String LAND_PREFIX = "LAND ";

  private final List<MissionItem> items = new ArrayList<>();
  private final List<String> names = new ArrayList<>();
  private double speed; // of the items so far [m/s]; 0: none

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
              && !uid.equals(VehicleStatus.GO_TO)
              && !uid.startsWith(LAND_PREFIX);
      if (isMission && byName.containsKey(uid)) {
        goals.add(byName.get(uid));
      }
    }
    return goals;
  }

  /**
   * The items.
   *
   * @throws PlanRefusal naming the goal that items cannot express
   */
  static MissionPlan plan(MissionReport report, VehicleKind kind) {
    List<GoalInformation> goals = goals(report);
    PlanWriter writer = new PlanWriter();
    for (int i = 0; i < goals.size(); i++) {
      Optional<String> following =
          i + 1 < goals.size() ? Optional.of(goals.get(i + 1).uid()) : Optional.empty();
      writer.write(goals.get(i), following, kind);
    }
    return new MissionPlan(report.mission(), writer.items, writer.names);
  }

  private void write(GoalInformation goal, Optional<String> following, VehicleKind kind) {
    if (!(goal instanceof Waypoint waypoint)) {
      throw refusal(goal, "a " + goal.type().name() + " has no equivalent");
    }
    if (waypoint.type() != Waypoint.TYPE && waypoint.type() != Station.TYPE) {
      throw refusal(goal, "a " + goal.type().name() + " has no equivalent");
    }
    Geodetic place =
        Placement.place(waypoint)
            .orElseThrow(() -> refusal(goal, "it has no longitude and latitude"));
    if (waypoint.speed().isPresent() && waypoint.speed().getAsDouble() != speed) {
      speed = waypoint.speed().getAsDouble();
      add(MissionItem.action(MissionItem.CHANGE_SPEED, 0.0f, (float) speed), goal.uid());
    }
    boolean hasAltitude = waypoint.z().isPresent() && !kind.isOnSurface();
    double holdS = waypoint instanceof Station station ? station.duration().orElse(0.0) : 0.0;
    add(
        MissionItem.at(
                hasAltitude ? MissionItem.GLOBAL : MissionItem.GLOBAL_RELATIVE,
                MissionItem.WAYPOINT,
                place.latitudeDeg(),
                place.longitudeDeg(),
                hasAltitude ? place.altitudeM() : 0.0)
            .with(
                (float) holdS,
                (float) waypoint.horizontalThreshold(),
                waypoint.psi().isPresent()
                    ? (float) Math.toDegrees(waypoint.psi().getAsDouble())
                    : Float.NaN),
        goal.uid());
    writeLinks(goal, following);
  }

  private void writeLinks(GoalInformation goal, Optional<String> following) {
    if (goal.repeatFrom().isPresent()) {
      int target = names.lastIndexOf(goal.repeatFrom().get());
      if (target < 0) {
        throw refusal(goal, "it repeats from a later goal");
      }
      add(
          MissionItem.action(MissionItem.JUMP, target, goal.repeatTimes().orElse(1)),
          following.orElse(""));
    }
    List<String> done = goal.nextIf(GoalResult.DONE).orElse(goal.next());
    boolean returns = following.isEmpty() && done.equals(List.of(VehicleStatus.HOME));
    boolean isUsual =
        done.isEmpty() || following.isPresent() && done.equals(List.of(following.get()));
    boolean branches =
        goal.nextIf(GoalResult.FAILED).isPresent() || goal.nextIf(GoalResult.TIMED_OUT).isPresent();
    if (branches || goal.choose().isPresent() || !isUsual && !returns) {
      throw refusal(goal, "what follows it is not only the next goal");
    }
    if (returns) {
      add(MissionItem.action(MissionItem.RETURN, 0.0f, 0.0f), VehicleStatus.HOME);
    }
  }

  private void add(MissionItem item, String goal) {
    items.add(item);
    names.add(goal);
  }

  private static PlanRefusal refusal(GoalInformation goal, String why) {
    return new PlanRefusal(
        MavMissionResult.MAV_MISSION_UNSUPPORTED, "goal \"" + goal.uid() + "\": " + why);
  }
}
