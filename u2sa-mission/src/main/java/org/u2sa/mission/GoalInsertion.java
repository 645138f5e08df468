package org.u2sa.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.schema.MessageType;

/** Inserts goals into a mission between a goal and its followers. */
final class GoalInsertion {
  private final GoalSequence mission;
  private final List<GoalInformation> goals;

  /**
   * @param goals at least one, with names not used in the mission
   */
  GoalInsertion(GoalSequence mission, List<GoalInformation> goals) {
    this.mission = mission;
    this.goals = goals;
  }

  /**
   * Inserts them after a goal.
   *
   * @param after name of a known goal
   */
  void after(String after) {
    add(mission.followers().usual(after));
    GoalInformation before = mission.book().goal(after);
    GoalInformation change = empty(before.type());
    change.uid(after);
    List<String> next = List.of(first());
    if (before.nextIf(GoalResult.DONE).isPresent()) {
      change.nextIf(GoalResult.DONE, next);
    } else {
      change.next(next);
    }
    mission.update(change);
  }

  private static GoalInformation empty(MessageType<?> type) {
    return (GoalInformation) type.create();
  }

  /** Inserts the goals before the current ones, which are pursued again afterwards. */
  void now() {
    Set<String> current = mission.currentNames();
    add(new ArrayList<>(current));
    mission.putBefore(first());
  }

  private String first() {
    return goals.get(0).uid();
  }

  /** Adds the goals and links those without followers to the given ones. */
  private void add(List<String> exit) {
    boolean ordered = goals.stream().noneMatch(Followers::isLinked);
    for (int i = 0; i < goals.size(); i++) {
      GoalInformation goal = goals.get(i);
      if (!Followers.isLinked(goal)) {
        goal = goal.copy();
        goal.next(ordered && i + 1 < goals.size() ? List.of(goals.get(i + 1).uid()) : exit);
        goal.freeze();
      }
      mission.update(goal);
    }
  }

  /** Their names. */
  String names() {
    return goals.stream().map(goal -> "\"" + goal.uid() + "\"").collect(Collectors.joining(", "));
  }
}
