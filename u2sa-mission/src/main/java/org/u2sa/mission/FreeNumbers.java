package org.u2sa.mission;

import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Names for the goals of a file that have none: their number in the file, or, where goals are added
 * to a mission, the first number that names no goal of either. Takes linear time.
 */
final class FreeNumbers {
  private final boolean isAdding;
  private final Set<String> names; // of the mission and of the file
  private int place; // of the goal requested last
  private int number; // last one tried

  /**
   * @param read the file's goals
   * @param taken names of the mission's goals; empty if the file is the mission
   */
  FreeNumbers(List<GoalElement> read, Collection<String> taken) {
    isAdding = !taken.isEmpty();
    names = new HashSet<>(taken);
    read.forEach(goal -> goal.field("uid").ifPresent(uid -> names.add(goal.message().uid())));
  }

  /** Free name for the next goal in file order; empty if the goal has a name. */
  Optional<String> next(GoalElement goal) {
    place++;
    if (goal.field("uid").isPresent()) {
      return Optional.empty();
    }
    if (!isAdding) {
      return Optional.of(String.valueOf(place));
    }
    do {
      number++;
    } while (names.contains(String.valueOf(number)));
    return Optional.of(String.valueOf(number));
  }
}
