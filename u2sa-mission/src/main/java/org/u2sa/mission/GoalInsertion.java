package org.u2sa.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;

/** Inserts goals into a mission between a goal and its followers. */
record GoalInsertion(GoalSequence mission, List<GoalInformation> goals) {
  /** Inserts them after a known goal. */
  void after(String after) {
    GoalInformation before = mission.book.goal(after);
    GoalInformation change = (GoalInformation) before.type().create();
    change.uid(after);
    List<String> next = List.of(first());
    List<String> exit = mission.followers.usual(after);
    if (before.nextIf(GoalResult.DONE).isPresent()) {
      boolean ends = mission.followers.end(after, GoalResult.DONE);
      add(last -> lead(last, exit, before, ends));
      change.nextIf(GoalResult.DONE, next);
    } else {
      add(last -> lead(last, exit, before, false));
      change.next(next);
    }
    mission.update(change);
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

  /** Adds the goals with an end of the mission after them, and returns the first one's name. */
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
