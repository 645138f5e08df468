package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.u2sa.gcs.mavlink.telemetry.Placement;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.gcs.plan.PlanItem;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionReport;

/**
 * The mission as items: the uploaded items while the Mission Manager pursues them unchanged, so
 * that they read back unchanged; otherwise its goals. Shared by all stations.
 */
public final class PlanBook {
  /** Origin of a mission that a station has cleared. */
  static final String CLEARED = "cleared by a ground station";

  private static final double DEGREES = 1.0e-9;
  private static final int MAX_CHARACTERS = 65_536; // of MissionOrder.goals; it is ASCII

  private final VehicleStatus vehicle;
  private final Placement placement;
  private final Identity identity;
  private MissionPlan uploaded = new MissionPlan("", List.of(), List.of());
  private int uploads;
  private MissionReport viewed; // the report from which the plan was made
  private MissionPlan plan = uploaded;
  private Optional<PlanRefusal> refusal = Optional.empty();

  public PlanBook(VehicleStatus vehicle, Placement placement, Identity identity) {
    this.vehicle = vehicle;
    this.placement = placement;
    this.identity = identity;
  }

  /**
   * Reads uploaded items.
   *
   * @throws PlanRefusal if one cannot be expressed
   */
  Upload read(List<MissionItem> items) {
    List<MissionItem> own = items.subList(Math.min(first(), items.size()), items.size());
    PlanReader reader = new PlanReader(vehicle.kind(), placement.home(), own, first());
    String xml = reader.xml();
    if (xml.length() > MAX_CHARACTERS) {
      throw new PlanRefusal(
          MavMissionResult.MAV_MISSION_NO_SPACE,
          "mission of " + own.size() + " items: too long for one order; expected about 400");
    }
    String origin = "uploaded by a ground station, no. " + ++uploads;
    return new Upload(new MissionPlan(origin, own, reader.names()), xml, reader.details());
  }

  /** An upload, its mission in XML, and the parameters left out. */
  record Upload(MissionPlan plan, String xml, List<String> details) {}

  /** Remembers an upload that the Mission Manager has accepted. */
  void accepted(MissionPlan accepted) {
    uploaded = accepted;
  }

  /**
   * The present mission.
   *
   * @throws PlanRefusal if items cannot express it
   */
  MissionPlan plan() {
    view();
    refusal.ifPresent(
        why -> {
          throw why;
        });
    return plan;
  }

  private void view() {
    MissionReport report = vehicle.report().orElse(null);
    if (report == viewed) {
      return;
    }
    viewed = report;
    refusal = Optional.empty();
    try {
      plan =
          report.mission().equals(CLEARED)
              ? new MissionPlan(CLEARED, List.of(), List.of())
              : isUploaded(report) ? uploaded : PlanWriter.plan(report, vehicle.kind(), first());
    } catch (PlanRefusal e) {
      plan = new MissionPlan(report.mission(), List.of(), List.of());
      refusal = Optional.of(e);
    }
  }

  private boolean isUploaded(MissionReport report) {
    Set<String> places = new HashSet<>(uploaded.goals());
    places.remove("");
    places.remove(VehicleStatus.HOME);
    List<GoalInformation> goals = PlanWriter.goals(report);
    return report.mission().equals(uploaded.origin())
        && goals.size() == places.size()
        && goals.stream().allMatch(this::isWhereUploaded);
  }

  private boolean isWhereUploaded(GoalInformation goal) {
    int index = uploaded.indexOf(goal.uid());
    if (index < 0 || !(goal instanceof Waypoint waypoint)) {
      return false;
    }
    MissionItem item = uploaded.items().get(index);
    return waypoint.x().isEmpty()
        || Math.abs(waypoint.x().getAsDouble() - item.longitudeDeg()) < DEGREES
            && Math.abs(waypoint.y().orElse(0.0) - item.latitudeDeg()) < DEGREES;
  }

  /** Items as stations count them: with home as item 0 if the identity requires it. */
  List<MissionItem> listed() {
    List<MissionItem> items = plan().items();
    if (!identity.startsWithHome()) {
      return items;
    }
    Geodetic home = placement.home().orElse(new Geodetic(0.0, 0.0, 0.0));
    List<MissionItem> listed = new ArrayList<>();
    listed.add(
        MissionItem.of(
            PlanItem.at(
                0,
                PlanItem.WAYPOINT,
                PlanItem.GLOBAL,
                List.of(home.latitudeDeg(), home.longitudeDeg(), home.altitudeM()),
                0.0,
                0.0,
                0.0,
                Double.NaN),
            0));
    listed.addAll(items);
    return listed;
  }

  /** Sequence number of the mission's first item. */
  private int first() {
    return identity.startsWithHome() ? 1 : 0;
  }

  /** Number of items as stations count them; 0 if the mission cannot be expressed. */
  public int size() {
    view();
    return plan.items().size() + (plan.items().isEmpty() ? 0 : first());
  }

  /** Index of a goal as stations count it; empty if no item represents it. */
  public Optional<Integer> index(String goal) {
    view();
    int index = plan.indexOf(goal);
    return index < 0 ? Optional.empty() : Optional.of(index + first());
  }

  /** Goal at an index as stations count it; empty if there is none. */
  public Optional<String> goal(int index) {
    view();
    int own = index - first();
    return IntStream.range(0, plan.goals().size())
        .filter(each -> each == own)
        .mapToObj(plan.goals()::get)
        .filter(goal -> !goal.isEmpty())
        .findFirst();
  }

  /** First goal of the mission; empty without one. */
  public Optional<String> firstGoal() {
    view();
    return plan.goals().stream().filter(goal -> !goal.isEmpty()).findFirst();
  }
}
