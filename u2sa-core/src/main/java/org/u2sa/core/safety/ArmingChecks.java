package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.GoalList;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EmergencyLatch;

/** What must be before the vehicle may move, and why not if it is not. */
final class ArmingChecks {
  /** Actuators announce themselves every 5 s; one that did not for three times is gone. */
  private static final double GONE_AFTER_S = 15.0;

  private final Configurator configuration;
  private final List<Watch> watches;
  private final Conditions conditions;
  private final EmergencyLatch emergency;
  private final LandMission landMission;
  private final Map<String, Long> actuators = new TreeMap<>(); // when each was heard last [µs]
  private boolean mission;
  private List<String> fileFaults = List.of();

  ArmingChecks(
      Configurator configuration,
      List<Watch> watches,
      Conditions conditions,
      EmergencyLatch emergency,
      LandMission landMission) {
    this.configuration = configuration;
    this.watches = watches;
    this.conditions = conditions;
    this.emergency = emergency;
    this.landMission = landMission;
    configuration.getVariable(SafetyVariables.MISSION_REQUIRED);
    configuration.getVariable(SafetyVariables.REQUIRED_ACTUATORS);
  }

  void see(U2SAData message, long nowMicros) {
    if (message instanceof GoalList goals) {
      mission = !goals.goals().isEmpty();
      fileFaults = goals.fileFaults();
    } else if (message instanceof ActuatorAnnouncement announcement) {
      actuators.put(announcement.actuatorName(), nowMicros);
    }
  }

  /** All that speaks against arming now; empty if nothing does. */
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
    if (!mission && configuration.getVariable(SafetyVariables.MISSION_REQUIRED)) {
      reasons.add("mission: no goals");
    }
    fileFaults.forEach(fault -> reasons.add("mission: " + fault));
    actuators(nowMicros).ifPresent(reasons::add);
    landMission.objection().ifPresent(reasons::add);
    return reasons;
  }

  private Optional<String> actuators(long nowMicros) {
    actuators.values().removeIf(heard -> nowMicros - heard > Clock.micros(GONE_AFTER_S));
    List<String> required =
        Words.names(configuration.getVariable(SafetyVariables.REQUIRED_ACTUATORS));
    required.removeAll(actuators.keySet());
    if (!required.isEmpty()) {
      return Optional.of("actuators: not there: " + String.join(", ", required));
    }
    return actuators.isEmpty() ? Optional.of("actuators: none is there") : Optional.empty();
  }
}
