package org.u2sa.core.mission;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.interfaces.xml.XmlElement;

/** Which goals of a file lead to which. */
final class GoalGraph {
  private final Map<String, GoalElement> goals;

  GoalGraph(Map<String, GoalElement> goals) {
    this.goals = goals;
  }

  /** Refuses a {@code <next>} that names no goal. */
  void refuseUnknownSuccessors() {
    for (GoalElement goal : goals.values()) {
      for (String next : goal.message().next()) {
        if (!goals.containsKey(next)) {
          XmlElement element = goal.field("next").orElse(goal.element());
          throw element.error(
              "\""
                  + next
                  + "\" names no goal; the goals are "
                  + String.join(", ", goals.keySet())
                  + NearestNames.didYouMean(next, goals.keySet()));
        }
      }
    }
  }

  /** A warning for each goal that is reached from the first one by no way of {@code <next>}. */
  List<String> warnings() {
    List<String> warnings = new ArrayList<>();
    if (goals.values().stream().allMatch(goal -> goal.message().next().isEmpty())) {
      return warnings; // the file's order leads to each
    }
    Set<String> reachable = reachable();
    goals.forEach(
        (name, goal) -> {
          if (!reachable.contains(name)) {
            warnings.add(
                goal.element()
                    + ": no <next> leads to goal \""
                    + name
                    + "\" from the first; it is pursued on command only");
          }
        });
    return warnings;
  }

  private Set<String> reachable() {
    Set<String> reachable = new LinkedHashSet<>();
    Deque<String> open = new ArrayDeque<>();
    open.add(goals.keySet().iterator().next());
    while (!open.isEmpty()) {
      String name = open.remove();
      if (reachable.add(name)) {
        open.addAll(goals.get(name).message().next());
      }
    }
    return reachable;
  }
}
