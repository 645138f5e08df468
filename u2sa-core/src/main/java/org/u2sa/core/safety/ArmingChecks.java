package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.actuator.EmergencyLatch;

/** Collects the reasons not to arm. */
final class ArmingChecks {
  /**
   * Actuators announce themselves every 5 s; one counts as gone after missing three announcements.
   */
  private static final double GONE_AFTER_S = 15.0;

  private final Configurator matrix;
  private final Supplier<SafetyVariables> settings;
  private final List<Watch> watches;
  private final Conditions conditions;
  private final EmergencyLatch emergency;
  private final Map<String, Long> actuators = new TreeMap<>(); // when last heard from [µs]
  private boolean mission;
  private OptionalLong landGoals = OptionalLong.empty(); // empty if unknown
  private List<String> fileFaults = List.of();

  ArmingChecks(
      Configurator matrix,
      Supplier<SafetyVariables> settings,
      List<Watch> watches,
      Conditions conditions,
      EmergencyLatch emergency) {
    this.matrix = matrix;
    this.settings = settings;
    this.watches = watches;
    this.conditions = conditions;
    this.emergency = emergency;
  }

  void see(U2SAData message, long nowMicros) {
    if (message instanceof GoalList goals) {
      mission = !goals.goals().isEmpty();
      fileFaults = goals.fileFaults();
      landGoals = goals.landGoals().isPresent() ? goals.landGoals() : landGoals;
    } else if (message instanceof ActuatorAnnouncement announcement) {
      if (announcement.available().orElse(1.0) > 0.0) {
        actuators.put(announcement.actuatorName(), nowMicros);
      } else {
        actuators.remove(announcement.actuatorName()); // withdrawn, or its device is lost
      }
    }
  }

  /** Current reasons not to arm; empty if none. */
  List<String> reasons(long nowMicros) {
    List<String> reasons = new ArrayList<>();
    emergency
        .stop()
        .ifPresent(
            stop -> reasons.add("emergency stop by \"" + stop.operator() + "\": " + stop.reason()));
    reasons.addAll(conditions.notAlive());
    for (Watch watch : watches) {
      watch
          .objection(nowMicros)
          .ifPresent(words -> reasons.add(watch.hazard().words() + ": " + words));
    }
    if (!mission && settings.get().missionRequired()) {
      reasons.add("mission: no goals");
    }
    fileFaults.forEach(fault -> reasons.add("mission: " + fault));
    actuators(nowMicros).ifPresent(reasons::add);
    landMission().ifPresent(reasons::add);
    return reasons;
  }

  private Optional<String> actuators(long nowMicros) {
    actuators.values().removeIf(heard -> nowMicros - heard > Clock.micros(GONE_AFTER_S));
    List<String> required = CauseText.names(settings.get().requiredActuators());
    required.removeAll(actuators.keySet());
    if (!required.isEmpty()) {
      return Optional.of("actuators: missing: " + String.join(", ", required));
    }
    return actuators.isEmpty() ? Optional.of("actuators: none announced") : Optional.empty();
  }

  /** A mission with a landing must be loaded if any hazard's action is LAND. */
  private Optional<String> landMission() {
    return watches.stream()
        .map(Watch::hazard)
        .filter(hazard -> hazard.action(matrix) == FailsafeAction.LAND)
        .filter(hazard -> landGoals.orElse(0) == 0)
        .map(
            hazard ->
                "failsafe matrix: "
                    + hazard.variable()
                    + " is LAND, but "
                    + (landGoals.isPresent()
                        ? "the Mission Manager has loaded no LAND MISSION"
                        : "no Mission Manager has reported a loaded LAND MISSION"))
        .findFirst();
  }
}
