package org.u2sa.cli.describe;

import java.util.ArrayList;
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
   * One dimension.
   *
   * @param stated level in the system file; empty if not stated
   * @param shown level derived from services and channels
   * @param because evidence for it
   */
  record Finding(String dimension, Optional<Level> stated, Level shown, String because) {
    /** Whether the stated level exceeds the derived one. */
    boolean isUnproven() {
      return stated.filter(level -> level.number() > shown.number()).isPresent();
    }
  }

  /** The three dimensions. */
  List<Finding> findings() {
    Optional<AutonomyLevels> stated = vehicle.stated();
    return List.of(
        perception(stated.map(AutonomyLevels::perception)),
        decision(stated.map(AutonomyLevels::decision)),
        independence(stated.map(AutonomyLevels::independence)));
  }

  private Finding perception(Optional<Level> stated) {
    List<String> own = vehicle.publishersOf(SENSED_STATE);
    Set<String> seeing = new LinkedHashSet<>(vehicle.publishersOf(Channels.SENSED_OBJECTS.name()));
    seeing.addAll(vehicle.publishersOf(Channels.SCANS.name()));
    List<String> around = List.copyOf(seeing);
    List<String> modelers = vehicle.publishersOf(OBJECTS);
    String sensors =
        (own.isEmpty()
                ? "nothing measures the vehicle"
                : DataFlowSummary.and(own)
                    + (own.size() == 1 ? " measures" : " measure")
                    + " the vehicle")
            + ", "
            + (around.isEmpty()
                ? "nothing its surroundings"
                : DataFlowSummary.and(around) + " the surroundings");
    if (own.isEmpty() && around.isEmpty()) {
      return new Finding("perception", stated, Perception.NO_SENSING, sensors);
    }
    if (around.isEmpty() || modelers.isEmpty()) {
      return new Finding("perception", stated, Perception.DISCRETE, sensors);
    }
    return new Finding(
        "perception",
        stated,
        Perception.GROUPED,
        sensors + "; " + DataFlowSummary.and(modelers) + " groups what is seen into objects");
  }

  private Finding decision(Optional<Level> stated) {
    List<String> planners = vehicle.ofRole("PATH_PLANNER");
    List<String> managers = vehicle.ofRole("MISSION_MANAGER");
    if (planners.isEmpty() || managers.isEmpty()) {
      return new Finding(
          "decision",
          stated,
          Decision.NO_DECISIONS,
          planners.isEmpty() ? "no Path Planner" : "no Mission Manager");
    }
    String plan =
        DataFlowSummary.and(managers)
            + " chooses goals by their results, "
            + DataFlowSummary.and(planners)
            + " the way";
    List<String> readers = new ArrayList<>(vehicle.subscribersOf(OBJECTS));
    readers.retainAll(planners);
    if (vehicle.publishersOf(OBJECTS).isEmpty() || readers.isEmpty()) {
      return new Finding(
          "decision",
          stated,
          Decision.STATIC_RESPONSE,
          plan + "; no map of objects is used for planning");
    }
    return new Finding(
        "decision",
        stated,
        Decision.MEMORY,
        plan
            + " with the map that "
            + DataFlowSummary.and(vehicle.publishersOf(OBJECTS))
            + " keeps");
  }

  private Finding independence(Optional<Level> stated) {
    List<String> control = vehicle.ofRole("CONTROL_SYSTEM");
    List<String> safety = vehicle.ofRole("SAFETY_MANAGER");
    List<String> health = vehicle.ofRole("HEALTH_MONITOR");
    boolean tasks =
        !vehicle.ofRole("MISSION_MANAGER").isEmpty() && !vehicle.ofRole("PATH_PLANNER").isEmpty();
    if (control.isEmpty() || vehicle.publishersOf(Channels.STATE.name()).isEmpty()) {
      return new Finding(
          "independence", stated, Independence.TELEOPERATION, "nothing controls by a state");
    }
    if (!tasks) {
      return new Finding(
          "independence",
          stated,
          Independence.STABILIZED,
          DataFlowSummary.and(control) + " controls; no mission");
    }
    if (health.isEmpty() && vehicle.publishersOf(Channels.POWER.name()).isEmpty()) {
      return new Finding(
          "independence",
          stated,
          Independence.TASK_AUTONOMY,
          DataFlowSummary.and(control)
              + " carries out the mission; nothing watches services or battery");
    }
    if (safety.isEmpty()) {
      return new Finding(
          "independence",
          stated,
          Independence.HEALTH_REPORTING,
          "health is reported, but no Safety Manager acts on it");
    }
    return new Finding(
        "independence",
        stated,
        Independence.PROBLEM_DETECTION,
        DataFlowSummary.and(safety)
            + " has failsafes and refuses to arm a vehicle that is not fit"
            + (health.isEmpty()
                ? ""
                : "; " + DataFlowSummary.and(health) + " restarts failed services"));
  }
}
