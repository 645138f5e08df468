package org.u2sa.core.mission;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.messages.GoalInformation;

/** Which goals of a file lead to which, whatever comes of them. */
final class GoalGraph {
  private final Map<String, GoalElement> goals;
  private final Collection<String> further; // known, though no goals of the file
  private final Followers followers;

  /**
   * @param further names that goals may name besides each other's
   */
  GoalGraph(Map<String, GoalElement> goals, Collection<String> further) {
    this.goals = goals;
    this.further = further;
    List<GoalInformation> messages =
        goals.values().stream().map(GoalElement::message).collect(Collectors.toList());
    followers = new Followers(new GoalBook(messages), Followers.orderOf(messages));
  }

  /** The names that a goal may name. */
  Set<String> known() {
    Set<String> known = new LinkedHashSet<>(goals.keySet());
    known.addAll(further);
    return known;
  }

  /** Refuses what names no goal. */
  void refuseUnknownSuccessors() {
    Set<String> known = known();
    goals.values().forEach(goal -> goal.links().refuseOthers(known));
  }

  /**
   * A warning for each goal that nothing leads to from the first one, and for goals from which
   * nothing leads to an end.
   *
   * @param also where the mission goes when its time limit passes
   * @param ends whether it ends anyway, by its time limit
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
                goal.element()
                    + ": no <next> leads to goal \""
                    + name
                    + "\" from the first; it is pursued on command only");
          }
        });
    Set<String> endless = endless(reachable);
    if (!ends && !endless.isEmpty()) {
      warnings.add(
          goals.get(endless.iterator().next()).element()
              + ": a loop without an exit: no <next> leads from "
              + String.join(", ", endless)
              + " to an end of the mission");
    }
    return warnings;
  }

  /** The goals from which the mission can reach no end, whatever comes of each. */
  private Set<String> endless(Set<String> reachable) {
    Set<String> ending = new LinkedHashSet<>();
    boolean grows = true;
    while (grows) {
      grows = false;
      for (String name : reachable) {
        boolean ends =
            !ending.contains(name)
                && followers.possible(name).values().stream()
                    .anyMatch(next -> next.isEmpty() || !Collections.disjoint(next, ending));
        if (ends || !ending.contains(name) && leadsFurther(name)) {
          ending.add(name);
          grows = true;
        }
      }
    }
    Set<String> endless = new LinkedHashSet<>(reachable);
    endless.removeAll(ending);
    return endless;
  }

  /** Whether a goal of another file, or the home, follows it. */
  private boolean leadsFurther(String name) {
    GoalInformation goal = goals.get(name).message();
    return !Collections.disjoint(goal.next(), further)
        || followers.possible(name).keySet().stream()
            .anyMatch(
                result ->
                    goal.nextIf(result)
                        .filter(next -> !Collections.disjoint(next, further))
                        .isPresent());
  }
}
