package org.u2sa.core.mission;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.Waypoint;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;

/** Reads {@code <mission>} (thesis 3.2.3.2, 4.5.2.3) and refuses what contradicts itself. */
final class MissionReader {
  private final MessageTypes types;
  private final OptionalDouble defaultThresholdM;

  MissionReader(MessageTypes types, OptionalDouble defaultThresholdM) {
    this.types = types;
    this.defaultThresholdM = defaultThresholdM;
  }

  Mission read(XmlElement root) {
    root.refuseUnknownAttributes();
    Map<String, GoalElement> goals = new LinkedHashMap<>();
    for (XmlElement child : root.children()) {
      if (!child.name().equals("home")) {
        add(goals, child);
      }
    }
    if (goals.isEmpty()) {
      throw root.error(
          "holds no goals; expected at least one, such as <waypoint><x>…</x><y>…</y></waypoint>");
    }
    Optional<Home> home = root.child("home").map(HomeReader::read);
    WaypointRules.check(goals.values());
    GoalGraph graph = new GoalGraph(goals);
    graph.refuseUnknownSuccessors();
    return new Mission(root, home, messages(goals), graph.warnings());
  }

  private void add(Map<String, GoalElement> goals, XmlElement element) {
    GoalElement goal = GoalElement.read(element, goalType(element));
    if (lacksThreshold(goal)) {
      defaultThresholdM.ifPresent(((Waypoint) goal.message())::horizontalThreshold);
    }
    if (goal.field("uid").isEmpty()) {
      goal.message().uid(String.valueOf(goals.size() + 1));
    }
    GoalElement other = goals.putIfAbsent(goal.message().uid(), goal);
    if (other != null) {
      throw goal.field("uid")
          .orElse(element)
          .error(
              "the goal in line "
                  + other.element().line()
                  + " is named \""
                  + goal.message().uid()
                  + "\" already; names must differ (without one, a goal's name is its number in the file)");
    }
  }

  private static boolean lacksThreshold(GoalElement goal) {
    return goal.message() instanceof Waypoint && goal.field("horizontalThreshold").isEmpty();
  }

  private MessageType<? extends GoalInformation> goalType(XmlElement element) {
    MessageType<?> type =
        types
            .byElementName(element.name())
            .orElseThrow(
                () ->
                    element.error(
                        "unknown element in <mission>; expected home or a class of goals: "
                            + String.join(", ", goalNames())
                            + NearestNames.didYouMean(element.name(), goalNames())));
    MessageType<? extends GoalInformation> goal = asGoal(type);
    if (goal == null) {
      throw element.error(
          "is not a class of goals; expected one of " + String.join(", ", goalNames()));
    }
    if (goal.isAbstract()) {
      throw element.error(
          "is abstract: no goal can be of this class; expected one of "
              + String.join(", ", goalNames()));
    }
    return goal;
  }

  @SuppressWarnings("unchecked") // the message class was compared
  private static MessageType<? extends GoalInformation> asGoal(MessageType<?> type) {
    return GoalInformation.class.isAssignableFrom(type.messageClass())
        ? (MessageType<? extends GoalInformation>) type
        : null;
  }

  private List<String> goalNames() {
    List<String> names = new ArrayList<>();
    for (MessageType<?> type : types.all()) {
      if (asGoal(type) != null && !type.isAbstract()) {
        names.add(type.name().substring(0, 1).toLowerCase(Locale.ROOT) + type.name().substring(1));
      }
    }
    return names;
  }

  private List<GoalInformation> messages(Map<String, GoalElement> goals) {
    List<GoalInformation> messages = new ArrayList<>();
    for (GoalElement goal : goals.values()) {
      if (defaultThresholdM.isPresent() || !lacksThreshold(goal)) {
        goal.message().freeze();
      }
      messages.add(goal.message());
    }
    return messages;
  }
}
