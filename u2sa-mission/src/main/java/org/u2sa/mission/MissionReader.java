package org.u2sa.mission;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;

/** Reads {@code <mission>} (thesis 3.2.3.2, 4.5.2.3) and rejects contradictions. */
record MissionReader(MessageTypes types, OptionalDouble defaultThresholdM) {
  Mission read(XmlElement root) {
    root.refuseUnknownAttributes();
    Map<String, GoalElement> goals = goals(root, Collections.emptyList(), true);
    Optional<Home> home = root.child("home").map(Home::read);
    WaypointRules.check(goals.values());
    GoalGraph graph =
        new GoalGraph(
            goals,
            home.isPresent() && !goals.containsKey(Home.NAME)
                ? List.of(Home.NAME)
                : Collections.emptyList());
    graph.refuseUnknownSuccessors();
    Optional<MissionLimit> limit =
        root.child(MissionLimit.ELEMENT).map(element -> MissionLimit.read(element, graph.known()));
    return new Mission(
        root,
        home,
        messages(goals),
        limit,
        graph.warnings(
            limit.map(MissionLimit::next).orElse(Collections.emptyList()), limit.isPresent()));
  }

  /**
   * Reads goals to add to a mission: they may lead to the mission's goals, and their names must be
   * new.
   *
   * @param mission existing goals of the mission
   */
  List<GoalInformation> readAdded(XmlElement root, GoalBook mission) {
    List<String> known = mission.names();
    refuseAllBut(root);
    Map<String, GoalElement> goals = goals(root, known, true);
    for (GoalElement goal : goals.values()) {
      if (known.contains(goal.message().uid())) {
        throw goal.field("uid")
            .orElse(goal.element())
            .error(
                String.format(
                    "the mission has a goal \"%s\"; expected another name, or update",
                    goal.message().uid()));
      }
    }
    WaypointRules.check(goals.values(), mission);
    new GoalGraph(goals, known).refuseUnknownSuccessors();
    return messages(goals);
  }

  /**
   * Reads changed fields of goals.
   *
   * @param known the mission's goals
   * @return goals with only their names and the changed fields set
   */
  List<GoalInformation> readChanged(XmlElement root, GoalBook known) {
    refuseAllBut(root);
    Map<String, GoalElement> goals = goals(root, known.names(), false);
    List<GoalElement> changed = new ArrayList<>();
    for (GoalElement goal : goals.values()) {
      GoalInformation change = goal.message();
      String expected = "lacks <name>; expected the name of the goal that changes";
      XmlElement name = goal.field("uid").orElseThrow(() -> goal.element().error(expected));
      GoalLinks.refuseUnless(known.names(), name, change.uid());
      GoalInformation now = known.goal(change.uid());
      if (now.type() != change.type()) {
        throw goal.element()
            .error("the mission's goal \"" + change.uid() + "\" is a " + now.type().name());
      }
      changed.add(goal.with(GoalBook.merged(now.copy(), change, Collections.emptyList())));
      goal.links().refuseOthers(known.names());
    }
    WaypointRules.check(changed, known);
    return goals.values().stream().map(GoalElement::message).collect(Collectors.toList());
  }

  private static void refuseAllBut(XmlElement root) {
    root.refuseUnknownAttributes();
    root.child(Home.NAME)
        .or(() -> root.child(MissionLimit.ELEMENT))
        .ifPresent(
            element -> {
              throw element.error("belongs to a whole mission; expected goals only");
            });
  }

  private Map<String, GoalElement> goals(
      XmlElement root, Collection<String> taken, boolean complete) {
    List<GoalElement> read = new ArrayList<>();
    for (XmlElement child : root.children()) {
      if (!child.name().equals(Home.NAME) && !child.name().equals(MissionLimit.ELEMENT)) {
        read.add(GoalElement.read(child, goalClass(child), complete));
      }
    }
    Map<String, GoalElement> goals = new LinkedHashMap<>();
    FreeNumbers numbers = new FreeNumbers(read, taken);
    read.forEach(goal -> add(goals, numbers, goal, complete));
    if (goals.isEmpty()) {
      throw root.error(
          "contains no goals; expected at least one, such as <waypoint><x>…</x><y>…</y></waypoint>");
    }
    return goals;
  }

  private MessageType<? extends GoalInformation> goalClass(XmlElement element) {
    List<String> names = new ArrayList<>();
    for (MessageType<?> each : types.all()) {
      if (asGoal(each) != null && !each.isAbstract()) {
        names.add(each.name().substring(0, 1).toLowerCase(Locale.ROOT) + each.name().substring(1));
      }
    }
    String known = String.join(", ", names);
    MessageType<?> type =
        types
            .byElementName(element.name())
            .orElseThrow(
                () ->
                    element.error(
                        "unknown element in <mission>; expected home or a class of goals: "
                            + known
                            + NearestNames.didYouMean(element.name(), names)));
    MessageType<? extends GoalInformation> goal = asGoal(type);
    if (goal == null) {
      throw element.error("is not a class of goals; expected one of " + known);
    }
    if (goal.isAbstract()) {
      throw element.error("is abstract: no goal can be of this class; expected one of " + known);
    }
    return goal;
  }

  @SuppressWarnings("unchecked") // the message class was compared
  private static MessageType<? extends GoalInformation> asGoal(MessageType<?> type) {
    return GoalInformation.class.isAssignableFrom(type.messageClass())
        ? (MessageType<? extends GoalInformation>) type
        : null;
  }

  private void add(
      Map<String, GoalElement> goals, FreeNumbers numbers, GoalElement goal, boolean complete) {
    if (complete && lacksThreshold(goal)) {
      defaultThresholdM.ifPresent(((Waypoint) goal.message())::horizontalThreshold);
    }
    numbers.next(goal).ifPresent(goal.message()::uid);
    GoalElement other = goals.putIfAbsent(goal.message().uid(), goal);
    if (other != null) {
      throw goal.field("uid")
          .orElse(goal.element())
          .error(
              String.format(
                  "the goal in line %s already has the name \"%s\"; names must differ (without "
                      + "one, a"
                      + " goal's name is its number in the file)",
                  other.element().line(), goal.message().uid()));
    }
  }

  private static boolean lacksThreshold(GoalElement goal) {
    return goal.message() instanceof Waypoint && goal.field("horizontalThreshold").isEmpty();
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
