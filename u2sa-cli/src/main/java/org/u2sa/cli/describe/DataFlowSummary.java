package org.u2sa.cli.describe;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.u2sa.cli.describe.VehicleComposition.AnnouncedActuator;
import org.u2sa.interfaces.communication.Channels;

/** Summary of the data flow from sensors to actuators, in a few sentences for newcomers. */
final class DataFlowSummary {
  private final VehicleComposition vehicle;
  private final List<String> sentences = new ArrayList<>();

  DataFlowSummary(VehicleComposition vehicle) {
    this.vehicle = vehicle;
  }

  List<String> sentences() {
    Set<String> around = new LinkedHashSet<>(publishers(Channels.SENSED_OBJECTS.name()));
    around.addAll(publishers(Channels.SCANS.name()));
    say(publishers(Channels.SENSED_STATE.name()), "measure", "the vehicle");
    say(List.copyOf(around), "measure", "its surroundings");
    sayOf("STATE_ESTIMATOR", "make", "one estimate of its position and motion");
    sayOf("WORLD_MODELER", "keep", "detected surroundings, as objects or a grid");
    sayOf("MISSION_MANAGER", "choose", "the next goal");
    sayOf("PATH_PLANNER", "plan", "the route there, and gives its next point");
    sayOf("CONTROL_SYSTEM", "command", moved());
    sayOf(
        "SAFETY_MANAGER", "let", "it move only when it is fit, and decides how to react to faults");
    sayOf("HEALTH_MONITOR", "restart", "what fails");
    return sentences;
  }

  private void sayOf(String role, String verb, String what) {
    say(vehicle.ofRole(role), verb, what);
  }

  private void say(List<String> who, String verb, String what) {
    if (!who.isEmpty()) {
      sentences.add(and(who) + " " + verb + (who.size() == 1 ? "s " : " ") + what + ".");
    }
  }

  private String moved() {
    List<String> names = vehicle.actuators().stream().map(AnnouncedActuator::name).toList();
    return names.isEmpty()
        ? "the actuators that move it to that point"
        : and(names) + " to go there";
  }

  private List<String> publishers(String channel) {
    List<String> names = new ArrayList<>(vehicle.publishersOf(channel));
    names.removeAll(vehicle.ofRole("STATE_ESTIMATOR"));
    return names;
  }

  /** "a, b and c". */
  static String and(List<String> names) {
    int last = names.size() - 1;
    return last < 1
        ? String.join("", names)
        : String.join(", ", names.subList(0, last)) + " and " + names.get(last);
  }
}
