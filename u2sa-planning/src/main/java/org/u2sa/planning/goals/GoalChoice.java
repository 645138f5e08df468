package org.u2sa.planning.goals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;

/** Chooses among the current goals, and predicts the next one. Immutable. */
public final class GoalChoice {
  private final GoalList list;

  public GoalChoice(GoalList list) {
    this.list = list;
  }

  /**
   * Goal to pursue: the preferred one if it is current, otherwise the nearest; on ties the first.
   *
   * @param preferred UID of the goal being pursued or predicted; empty if none
   */
  public Optional<GoalInformation> goal(
      String preferred, ToDoubleFunction<GoalInformation> distance) {
    return choose(list.goals(), preferred, distance);
  }

  public Optional<GoalInformation> after(
      GoalInformation goal, String preferred, ToDoubleFunction<GoalInformation> distance) {
    return choose(candidates(goal), preferred, distance);
  }

  private List<GoalInformation> candidates(GoalInformation goal) {
    if (list.goals().size() == 1) {
      return list.upcoming();
    }
    List<GoalInformation> candidates = new ArrayList<>();
    if (list.upcoming().isEmpty()) { // the other options stay current
      candidates.addAll(list.goals());
      candidates.removeIf(other -> other.uid().equals(goal.uid()));
    } else {
      candidates.addAll(list.upcoming());
      candidates.removeIf(other -> !goal.next().contains(other.uid()));
    }
    return candidates;
  }

  private static Optional<GoalInformation> choose(
      List<GoalInformation> options, String preferred, ToDoubleFunction<GoalInformation> distance) {
    GoalInformation nearest = null;
    double least = Double.POSITIVE_INFINITY;
    for (GoalInformation option : options) {
      if (option.uid().equals(preferred)) {
        return Optional.of(option);
      }
      double away = options.size() == 1 ? 0.0 : distance.applyAsDouble(option);
      if (nearest == null || away < least) {
        nearest = option;
        least = away;
      }
    }
    return Optional.ofNullable(nearest);
  }
}
