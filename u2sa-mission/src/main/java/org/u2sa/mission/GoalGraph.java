package org.u2sa.mission;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.messages.goal.GoalInformation;

/** Graph of the goals of a file, with edges for every result. */
final class GoalGraph {
  private final Map<String, GoalElement> goals;
  private final Collection<String> further; // known goals from outside the file
  private final Followers followers;

  GoalGraph(Map<String, GoalElement> goals, Collection<String> further) {
    this.goals = goals;
    this.further = further;
    List<GoalInformation> messages =
        goals.values().stream().map(GoalElement::message).collect(Collectors.toList());
    followers = new Followers(new GoalBook(messages), Followers.orderOf(messages));
  }

  /** Names that a goal may refer to. */
  Set<String> known() {
    Set<String> known = new LinkedHashSet<>(goals.keySet());
    known.addAll(further);
    return known;
  }

  void refuseUnknownSuccessors() {
    Set<String> known = known();
    goals.values().forEach(goal -> goal.links().refuseOthers(known));
  }

  /**
   * Warnings for goals that are unreachable from the first one, and for goals from which no end is
   * reachable.
   *
   * @param also goals that follow when the mission's time limit expires
   * @param ends whether the time limit ends the mission anyway
   */
  List<String> warnings(Collection<String> also, boolean ends) {
    List<String> from = new ArrayList<>(also);
    from.retainAll(goals.keySet());
    from.add(goals.keySet().iterator().next());
    Set<String> reachable = followers.reachable(from);
    List<String> warnings = new ArrayList<>();
    goals.forEach(
        (name, goal) -> {
          if (!reachable.contains(name)) {
            warnings.add(
                String.format(
                    "%s: no <next> leads to goal \"%s\" from the first; it is pursued on command only",
                    goal.element(), name));
          }
        });
    Set<String> endless = endless(reachable);
    if (!ends && !endless.isEmpty()) {
      warnings.add(
          String.format(
              "%s: a loop without an exit: no <next> leads from %s to an end of the mission",
              goals.get(endless.iterator().next()).element(), String.join(", ", endless)));
    }
    return warnings;
  }

  /**
   * Goals from which no end of the mission is reachable, whatever their results; found by a
   * backward search from the end goals, so that each link is visited once.
   */
  private Set<String> endless(Set<String> reachable) {
    Map<String, List<String>> before = new HashMap<>();
    Deque<String> open = new ArrayDeque<>();
    for (String name : reachable) {
      for (List<String> next : followers.possible(name).values()) {
        next.forEach(one -> before.computeIfAbsent(one, any -> new ArrayList<>()).add(name));
        if (next.isEmpty()) {
          open.add(name);
        }
      }
      if (leadsFurther(name)) {
        open.add(name);
      }
    }
    Set<String> endless = new LinkedHashSet<>(reachable);
    while (!open.isEmpty()) {
      String ending = open.remove();
      if (endless.remove(ending)) {
        open.addAll(before.getOrDefault(ending, Collections.emptyList()));
      }
    }
    return endless;
  }

  /** Whether it is followed by the home or a goal of another file. */
  private boolean leadsFurther(String name) {
    GoalInformation goal = goals.get(name).message();
    return !Collections.disjoint(goal.next(), further)
        || followers.possible(name).keySet().stream()
            .flatMap(result -> goal.nextIf(result).stream())
            .anyMatch(next -> !Collections.disjoint(next, further));
  }
}
