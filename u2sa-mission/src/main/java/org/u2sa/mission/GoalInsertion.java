package org.u2sa.mission;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;

/** Inserts goals into a mission between a goal and its followers. */
record GoalInsertion(GoalSequence mission, List<GoalInformation> goals) {
  /**
   * Inserts the goals after a known goal and after its alternatives that lead to the same
   * followers; otherwise those followers would become current beside the inserted goals.
   *
   * @return the goals that lead to the inserted ones
   */
  List<String> after(String after) {
    List<String> exit = mission.followers.usual(after);
    GoalInformation before = mission.book.goal(after);
    boolean ends =
        before.nextIf(GoalResult.DONE).isPresent() && mission.followers.end(after, GoalResult.DONE);
    List<String> ways = mission.book.names();
    ways.retainAll(mission.together(after));
    ways.removeIf(way -> !new HashSet<>(mission.followers.usual(way)).equals(new HashSet<>(exit)));
    add(last -> lead(last, exit, before, ends));
    ways.forEach(this::leadIn);
    if (mission.currentNames().contains(after)) {
      mission.postpone(exit);
    }
    return ways;
  }

  private void leadIn(String way) {
    GoalInformation before = mission.book.goal(way);
    GoalInformation change = (GoalInformation) before.type().create();
    change.uid(way);
    List<String> next = List.of(first());
    mission.update(
        before.nextIf(GoalResult.DONE).isPresent()
            ? change.nextIf(GoalResult.DONE, next)
            : change.next(next));
  }

  /** Gives an inserted goal the successors and rules of the goal before it. */
  private static void lead(
      GoalInformation last, List<String> exit, GoalInformation before, boolean ends) {
    if (ends) {
      last.nextIf(GoalResult.DONE, exit); // an explicit end of the mission, not the end of a lap
    } else {
      last.next(exit);
    }
    if (before.choose().isPresent() && last.choose().isEmpty()) {
      last.choose(before.choose().getAsLong());
    }
  }

  /** Inserts the goals before the current ones, which are pursued again afterwards. */
  void now() {
    Set<String> current = mission.currentNames();
    List<String> exit = new ArrayList<>(current);
    add(last -> last.next(exit));
    mission.putBefore(first());
  }

  /** Adds the goals, followed by the end of the mission, and returns the name of the first. */
  String toTheEnd() {
    add(last -> last.nextIf(GoalResult.DONE, List.of()));
    return first();
  }

  private String first() {
    return goals.get(0).uid();
  }

  /** Adds the goals; {@code exit} links one without followers to those in the mission. */
  private void add(Consumer<GoalInformation> exit) {
    boolean ordered = goals.stream().noneMatch(Followers::isLinked);
    for (int i = 0; i < goals.size(); i++) {
      GoalInformation goal = goals.get(i);
      if (!Followers.isLinked(goal)) {
        goal = goal.copy();
        if (ordered && i + 1 < goals.size()) {
          goal.next(List.of(goals.get(i + 1).uid()));
        } else {
          exit.accept(goal);
        }
        goal.freeze();
      }
      mission.update(goal);
    }
  }

  String names() {
    return goals.stream().map(goal -> "\"" + goal.uid() + "\"").collect(Collectors.joining(", "));
  }
}
