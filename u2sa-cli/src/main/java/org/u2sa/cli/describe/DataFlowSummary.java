package org.u2sa.cli.describe;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.cli.describe.VehicleComposition.AnnouncedActuator;
import org.u2sa.interfaces.communication.Channels;

/** Summary of the data flow from sensors to actuators, in a few sentences for newcomers. */
final class DataFlowSummary {
  private final VehicleComposition vehicle;

  DataFlowSummary(VehicleComposition vehicle) {
    this.vehicle = vehicle;
  }

  /** One sentence per step. */
  List<String> sentences() {
    List<String> all = new ArrayList<>();
    List<String> around = new ArrayList<>(publishers(Channels.SENSED_OBJECTS.name()));
    around.addAll(publishers(Channels.SCANS.name()));
    say(all, publishers(Channels.SENSED_STATE.name()), "measures", "measure", "the vehicle");
    say(all, distinct(around), "measures", "measure", "what is around it");
    say(
        all,
        vehicle.ofRole("STATE_ESTIMATOR"),
        "makes",
        "make",
        "one estimate of where it is and how it moves");
    say(
        all,
        vehicle.ofRole("WORLD_MODELER"),
        "keeps",
        "keep",
        "what was seen around it, as objects or a grid");
    say(all, vehicle.ofRole("MISSION_MANAGER"), "chooses", "choose", "the next goal");
    say(
        all,
        vehicle.ofRole("PATH_PLANNER"),
        "plans",
        "plan",
        "the route there, and gives its next point");
    say(all, vehicle.ofRole("CONTROL_SYSTEM"), "commands", "command", moved());
    say(
        all,
        vehicle.ofRole("SAFETY_MANAGER"),
        "lets",
        "let",
        "it move only when it is fit, and decides what happens when something is wrong");
    say(all, vehicle.ofRole("HEALTH_MONITOR"), "restarts", "restart", "what fails");
    return all;
  }

  private String moved() {
    List<String> names =
        vehicle.actuators().stream().map(AnnouncedActuator::name).collect(Collectors.toList());
    return names.isEmpty()
        ? "the actuators that move it to that point"
        : and(names) + " to go there";
  }

  private List<String> publishers(String channel) {
    List<String> names = new ArrayList<>(vehicle.publishersOf(channel));
    names.removeAll(vehicle.ofRole("STATE_ESTIMATOR"));
    return names;
  }

  private static List<String> distinct(List<String> names) {
    Set<String> once = new LinkedHashSet<>(names);
    return List.copyOf(once);
  }

  private static void say(
      List<String> all, List<String> who, String one, String several, String what) {
    if (!who.isEmpty()) {
      all.add(and(who) + " " + (who.size() == 1 ? one : several) + " " + what + ".");
    }
  }

  /** "a, b and c". */
  static String and(List<String> names) {
    int last = names.size() - 1;
    return last < 1
        ? String.join("", names)
        : String.join(", ", names.subList(0, last)) + " and " + names.get(last);
  }
}
