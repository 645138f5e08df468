package org.u2sa.mission;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;

/**
 * Determines the goals that follow a goal, by its result: those it names for this result, else its
 * repetition, else its {@code next}. If no goal of the mission has a {@code next}, goals follow in
 * file order. A timed-out goal without its own followers counts as failed; a skipped goal counts as
 * done.
 */
final class Followers {
  private final GoalBook book;
  private final List<String> order; // empty if the mission is linked by next
  private final Map<String, Integer> places = new HashMap<>(); // of the names in order

  Followers(GoalBook book, List<String> order) {
    this.book = book;
    this.order = List.copyOf(order);
    for (String name : order) {
      places.put(name, places.size());
    }
  }

  /** Names in file order; empty if a goal has a {@code next}. */
  static List<String> orderOf(Collection<? extends GoalInformation> goals) {
    List<String> names = new ArrayList<>();
    for (GoalInformation goal : goals) {
      if (isLinked(goal)) {
        return Collections.emptyList();
      }
      names.add(goal.uid());
    }
    return names;
  }

  /** Whether a goal names its own followers for the regular case. */
  static boolean isLinked(GoalInformation goal) {
    return !goal.next().isEmpty() || goal.nextIf(GoalResult.DONE).isPresent();
  }

  /** Names in file order; empty if the goals are linked. */
  List<String> order() {
    return order;
  }

  /**
   * Returns the goals that follow a goal now.
   *
   * @param repeats counters of started repetitions; updated
   */
  List<String> after(String uid, GoalResult result, Map<String, Long> repeats) {
    Optional<List<String>> own = own(book.goal(uid), result);
    Optional<String> again = own.isPresent() ? Optional.empty() : book.goal(uid).repeatFrom();
    long begun = repeats.getOrDefault(uid, 0L);
    if (again.filter(book::knows).isPresent() && begun < book.goal(uid).repeatTimes().orElse(1)) {
      repeats.put(uid, begun + 1);
      return Collections.singletonList(again.get());
    }
    repeats.remove(uid); // finished: the next repetition starts over
    return own.map(this::known).orElseGet(() -> otherwise(uid));
  }

  /** Whether the mission ends explicitly with this result of a goal. */
  boolean end(String uid, GoalResult result) {
    return own(book.goal(uid), result).filter(List::isEmpty).isPresent();
  }

  private static Optional<List<String>> own(GoalInformation goal, GoalResult result) {
    return switch (result) {
      case TIMED_OUT -> goal.nextIf(GoalResult.TIMED_OUT).or(() -> goal.nextIf(GoalResult.FAILED));
      case SKIPPED -> goal.nextIf(GoalResult.DONE);
      default -> goal.nextIf(result);
    };
  }

  /** Followers of a completed goal, without repetitions. */
  List<String> usual(String uid) {
    return usual(uid, GoalResult.DONE);
  }

  private List<String> usual(String uid, GoalResult result) {
    return own(book.goal(uid), result).map(this::known).orElseGet(() -> otherwise(uid));
  }

  private List<String> otherwise(String uid) {
    List<String> next = book.goal(uid).next();
    Integer place = places.get(uid);
    return !next.isEmpty() || place == null || place + 1 == order.size()
        ? known(next)
        : Collections.singletonList(order.get(place + 1));
  }

  /** Ignores unknown names, because an update may name goals that are added later. */
  private List<String> known(List<String> names) {
    List<String> known = new ArrayList<>(names);
    known.removeIf(name -> !book.knows(name));
    return known;
  }

  /** Possible followers of a goal, by result. Goals without a time limit cannot time out. */
  Map<GoalResult, List<String>> possible(String uid) {
    Map<GoalResult, List<String>> possible = new LinkedHashMap<>();
    for (GoalResult result : List.of(GoalResult.DONE, GoalResult.FAILED, GoalResult.TIMED_OUT)) {
      if (result != GoalResult.TIMED_OUT || book.goal(uid).timeLimit().isPresent()) {
        possible.put(result, usual(uid, result));
      }
    }
    return possible;
  }

  /** All goals reachable from these, including themselves. */
  Set<String> reachable(Collection<String> from) {
    Set<String> reachable = new LinkedHashSet<>();
    List<String> open = new ArrayList<>(from);
    while (!open.isEmpty()) {
      String name = open.remove(open.size() - 1);
      if (reachable.add(name)) {
        possible(name).values().forEach(open::addAll);
        book.goal(name).repeatFrom().filter(book::knows).ifPresent(open::add);
      }
    }
    return reachable;
  }
}
