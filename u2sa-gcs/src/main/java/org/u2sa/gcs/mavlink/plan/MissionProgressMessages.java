package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MissionCurrent;
import io.dronefleet.mavlink.common.MissionItemReached;
import io.dronefleet.mavlink.common.MissionState;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.gcs.mavlink.vehicle.VehicleMode;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.mission.MissionReport;

/** MISSION_CURRENT, and MISSION_ITEM_REACHED for goals that were completed. */
public final class MissionProgressMessages {
  private static final int NO_MISSION = 1; // MISSION_STATE
  private static final int NOT_STARTED = 2;
  private static final int ACTIVE = 3;
  private static final int PAUSED = 4;
  private static final int COMPLETE = 5;
  private static final int IN_MISSION_MODE = 1;
  private static final int SUSPENDED = 2;

  private final VehicleStatus vehicle;
  private final PlanBook book;
  private final Map<String, Double> completed = new HashMap<>(); // number of completions, by goal
  private MissionReport seen;
  private String mission = "";
  private int current; // last known item

  public MissionProgressMessages(VehicleStatus vehicle, PlanBook book) {
    this.vehicle = vehicle;
    this.book = book;
  }

  /** MISSION_CURRENT; empty until the mission is known. */
  public Optional<Object> current() {
    if (vehicle.report().isEmpty()) {
      return Optional.empty();
    }
    current = vehicle.current().flatMap(book::index).orElse(current);
    int size = book.size();
    boolean pursues = vehicle.mode() == VehicleMode.MISSION;
    return Optional.of(
        MissionCurrent.builder()
            .seq(Math.min(current, Math.max(0, size - 1)))
            .total(size)
            .missionState(EnumValue.create(MissionState.class, state(size)))
            .missionMode(pursues ? IN_MISSION_MODE : SUSPENDED)
            .build());
  }

  private int state(int size) {
    if (size == 0) {
      return NO_MISSION;
    }
    if (vehicle.current().isEmpty()) {
      return COMPLETE;
    }
    if (vehicle.mode() != VehicleMode.MISSION) {
      return PAUSED;
    }
    return vehicle.isArmed() ? ACTIVE : NOT_STARTED;
  }

  /** Items completed since the last call. */
  public List<Object> reached() {
    Optional<MissionReport> report = vehicle.report().filter(each -> each != seen);
    List<Object> reached = new ArrayList<>();
    report.ifPresent(
        now -> {
          seen = now;
          boolean isOther = !now.mission().equals(mission);
          mission = now.mission();
          if (isOther) {
            completed.clear();
          }
          for (int i = 0; i < now.goals().size() && i < now.finished().size(); i++) {
            GoalInformation goal = now.goals().get(i);
            double times = now.finished().get(i);
            double before = completed.getOrDefault(goal.uid(), 0.0);
            completed.put(goal.uid(), times);
            if (!isOther && times > before && goal.completed()) {
              book.index(goal.uid())
                  .ifPresent(seq -> reached.add(MissionItemReached.builder().seq(seq).build()));
            }
          }
        });
    return reached;
  }
}
