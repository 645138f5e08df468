package org.u2sa.cli.describe;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.u2sa.core.launch.AutonomyLevels;
import org.u2sa.core.launch.AutonomyLevels.Decision;
import org.u2sa.core.launch.AutonomyLevels.Independence;
import org.u2sa.core.launch.AutonomyLevels.Level;
import org.u2sa.core.launch.AutonomyLevels.Perception;
import org.u2sa.interfaces.communication.Channels;

/**
 * Derives autonomy levels (thesis 2.3) from a vehicle's services and channels. Levels without such
 * evidence, such as classification or learning, can only be stated in the system file.
 */
final class AutonomyEvidence {
  private static final String SENSED_STATE = Channels.SENSED_STATE.name();
  private static final String OBJECTS = Channels.OBJECTS.name();

  private final VehicleComposition vehicle;

  AutonomyEvidence(VehicleComposition vehicle) {
    this.vehicle = vehicle;
  }

  /**
   * One dimension: the level stated in the file, if any, and the level shown, with its evidence.
   */
  record Finding(String dimension, Optional<Level> stated, Level shown, String because) {
    boolean isUnproven() {
      return stated.filter(level -> level.number() > shown.number()).isPresent();
    }
  }

  private record Evidence(Level level, String text) {}

  List<Finding> findings() {
    Optional<AutonomyLevels> stated = vehicle.stated();
    return List.of(
        finding("perception", stated.map(AutonomyLevels::perception), perception()),
        finding("decision", stated.map(AutonomyLevels::decision), decision()),
        finding("independence", stated.map(AutonomyLevels::independence), independence()));
  }

  private static Finding finding(String dimension, Optional<Level> stated, Evidence evidence) {
    return new Finding(dimension, stated, evidence.level(), evidence.text());
  }

  private Evidence perception() {
    List<String> own = vehicle.publishersOf(SENSED_STATE);
    Set<String> seeing = new LinkedHashSet<>(vehicle.publishersOf(Channels.SENSED_OBJECTS.name()));
    seeing.addAll(vehicle.publishersOf(Channels.SCANS.name()));
    List<String> around = List.copyOf(seeing);
    String modelers = and(vehicle.publishersOf(OBJECTS));
    String sensors =
        (own.isEmpty()
                ? "no sensor measures the vehicle, "
                : and(own) + (own.size() == 1 ? " measures" : " measure") + " the vehicle, ")
            + (around.isEmpty() ? "none its surroundings" : and(around) + " the surroundings");
    if (own.isEmpty() && around.isEmpty()) {
      return new Evidence(Perception.NO_SENSING, sensors);
    }
    return around.isEmpty() || modelers.isEmpty()
        ? new Evidence(Perception.DISCRETE, sensors)
        : new Evidence(
            Perception.GROUPED, sensors + "; " + modelers + " groups detections into objects");
  }

  private Evidence decision() {
    List<String> planners = vehicle.ofRole("PATH_PLANNER");
    List<String> managers = vehicle.ofRole("MISSION_MANAGER");
    if (planners.isEmpty() || managers.isEmpty()) {
      return new Evidence(
          Decision.NO_DECISIONS, planners.isEmpty() ? "no Path Planner" : "no Mission Manager");
    }
    String plan = and(managers) + " chooses goals by their results, " + and(planners) + " the way";
    List<String> maps = vehicle.publishersOf(OBJECTS);
    return maps.isEmpty() || Collections.disjoint(vehicle.subscribersOf(OBJECTS), planners)
        ? new Evidence(Decision.STATIC_RESPONSE, plan + "; no map of objects is used for planning")
        : new Evidence(Decision.MEMORY, plan + " with the map that " + and(maps) + " keeps");
  }

  private Evidence independence() {
    String control = and(vehicle.ofRole("CONTROL_SYSTEM"));
    String safety = and(vehicle.ofRole("SAFETY_MANAGER"));
    String health = and(vehicle.ofRole("HEALTH_MONITOR"));
    if (control.isEmpty() || vehicle.publishersOf(Channels.STATE.name()).isEmpty()) {
      return new Evidence(Independence.TELEOPERATION, "no service controls by the state");
    }
    if (vehicle.ofRole("MISSION_MANAGER").isEmpty() || vehicle.ofRole("PATH_PLANNER").isEmpty()) {
      return new Evidence(Independence.STABILIZED, control + " controls; no mission");
    }
    if (health.isEmpty() && vehicle.publishersOf(Channels.POWER.name()).isEmpty()) {
      return new Evidence(
          Independence.TASK_AUTONOMY,
          control + " executes the mission; no service monitors services or battery");
    }
    return safety.isEmpty()
        ? new Evidence(
            Independence.HEALTH_REPORTING, "health is reported, but no Safety Manager acts on it")
        : new Evidence(
            Independence.PROBLEM_DETECTION,
            safety
                + " has failsafes and refuses to arm a vehicle that is not fit"
                + (health.isEmpty() ? "" : "; " + health + " restarts failed services"));
  }

  private static String and(List<String> names) {
    return DataFlowSummary.and(names);
  }
}
