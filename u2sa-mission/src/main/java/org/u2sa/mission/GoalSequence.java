package org.u2sa.mission;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.service.handover.HandOver;

/**
 * The order in which the goals of a mission become current (thesis 3.2.3.2, 3.2.3.3): {@link
 * Followers} determines the followers of a goal, this class the effect on other current goals.
 *
 * <p>A finished goal does not become current again unless all possible followers are finished: then
 * a new lap starts. Not thread-safe.
 */
final class GoalSequence {
  /** Policy for several current goals. */
  enum Options {
    /** All must be finished, in any order, before their followers. */
    ALL,
    /** One must be finished; its {@code next} names the followers. */
    ANY
  }

  final GoalBook book;
  final Followers followers;
  private final String first;
  private final Map<String, Long> pursuedMicros = new LinkedHashMap<>(); // by current goal
  private Position at;
  private boolean loop;
  private Options options;

  /**
   * @param goals at least one, with unique names, starting with the first goal of the mission
   * @param loop whether the mission restarts when no goal is left
   */
  GoalSequence(List<? extends GoalInformation> goals, boolean loop, Options options) {
    this(
        new GoalBook(goals), Followers.orderOf(goals), goals.get(0).uid(), new Position(), options);
    this.loop = loop;
    at.current.add(first);
  }

  private GoalSequence(
      GoalBook book, List<String> order, String first, Position at, Options options) {
    this.book = book;
    this.first = first;
    this.at = at;
    this.options = options;
    followers = new Followers(book, order);
  }

  /** Saves the progress under a name for a succeeding Mission Manager. */
  void handOver(HandOver state, String name) {
    book.handOver(state, name);
    at.handOver(state, name);
    state
        .texts(name + " ORDER", followers.order())
        .texts(name + " PURSUED TIMES", Position.texts(pursuedMicros))
        .text(name + " FIRST", first);
  }

  /** Restores the sequence saved under a name, with its progress; empty if none. */
  static Optional<GoalSequence> takenOver(
      HandOver state, String name, boolean loop, Options options) {
    return GoalBook.takenOver(state, name)
        .map(
            book -> {
              String first = state.text(name + " FIRST").orElseGet(() -> book.names().get(0));
              GoalSequence sequence =
                  new GoalSequence(
                      book,
                      state.texts(name + " ORDER"),
                      first,
                      Position.takenOver(state, name),
                      options);
              sequence.loop = loop;
              sequence.pursuedMicros.putAll(Position.numbers(state.texts(name + " PURSUED TIMES")));
              return sequence;
            });
  }

  void rules(boolean newLoop, Options newOptions) {
    loop = newLoop;
    options = newOptions;
  }

  /** Current goals; empty if the mission is over. */
  List<GoalInformation> current() {
    return book.named(at.current);
  }

  Set<String> currentNames() {
    return Collections.unmodifiableSet(at.current);
  }

  /**
   * Goals that become current after one of the current goals, for {@link
   * org.u2sa.messages.goal.GoalList#upcoming}.
   */
  List<GoalInformation> upcoming() {
    if (at.current.size() == 1) {
      Position ahead = new Position(at);
      move(ahead, at.current.iterator().next(), GoalResult.DONE);
      return book.named(ahead.current);
    }
    Set<String> next = new LinkedHashSet<>();
    if (options == Options.ANY || at.wanted > 0) {
      at.current.forEach(name -> next.addAll(followers.usual(name)));
      next.removeAll(at.finished);
    }
    return book.named(next);
  }

  /**
   * Goals of the landing in their usual order, from the one that starts it; empty without a
   * landing.
   */
  List<GoalInformation> landing() {
    Set<String> way = new LinkedHashSet<>();
    Optional<String> name = book.names().stream().filter(this::startsLanding).findFirst();
    while (name.isPresent() && way.add(name.get())) {
      name = followers.usual(name.get()).stream().findFirst();
    }
    return book.named(way);
  }

  private boolean startsLanding(String uid) {
    return book.goal(uid) instanceof Waypoint waypoint && waypoint.landingStart();
  }

  boolean knows(String uid) {
    return book.knows(uid);
  }

  boolean isOver() {
    return at.current.isEmpty();
  }

  /** {@link #finish(String, GoalResult, Optional, String, long)} for a completed goal. */
  boolean finish(String uid) {
    return finish(uid, GoalResult.DONE, Optional.empty(), "", 0);
  }

  /**
   * Advances from a goal that was completed or abandoned.
   *
   * @param report the Path Planner's report; empty if none
   * @param reason why it was abandoned; empty if it was not, or if the report contains the reason
   * @param micros current time [µs of the run's clock]
   * @return false if the goal is not current
   */
  boolean finish(
      String uid, GoalResult result, Optional<GoalInformation> report, String reason, long micros) {
    if (!at.current.contains(uid)) {
      return false;
    }
    book.finish(uid, result, report, reason, micros);
    pursuedMicros.remove(uid);
    move(at, uid, result);
    for (String name : at.current) {
      if (book.goal(name).result().isPresent()) {
        book.renew(name);
      }
    }
    return true;
  }

  /** Advances a position from a current goal. */
  private void move(Position from, String uid, GoalResult result) {
    from.current.remove(uid);
    from.finished.add(uid);
    from.ends |= followers.end(uid, result);
    List<String> next = followers.after(uid, result, from.repeats);
    if (from.wanted > 0) {
      from.pending.addAll(next);
      boolean done = result == GoalResult.DONE || result == GoalResult.SKIPPED;
      from.wanted -= done ? 1 : 0;
      if (from.wanted == 0 || from.current.isEmpty()) {
        openPending(from, uid);
      }
    } else if (options == Options.ALL) {
      from.pending.addAll(next);
      if (from.current.isEmpty()) {
        openPending(from, uid);
      }
    } else {
      open(from, next, uid);
    }
    if (from.current.isEmpty() && loop && !from.ends) {
      open(from, Collections.singletonList(first), uid);
    }
  }

  private void openPending(Position from, String after) {
    List<String> names = new ArrayList<>(from.pending);
    from.pending.clear();
    open(from, names, after);
  }

  private void open(Position from, List<String> names, String after) {
    from.current.clear();
    from.current.addAll(names);
    from.current.removeAll(from.finished);
    if (from.current.isEmpty()) { // a new lap
      from.finished.clear();
      from.current.addAll(names);
    }
    from.ends &= from.current.isEmpty();
    long chosen = book.goal(after).choose().orElse(0);
    from.wanted = from.current.size() > 1 ? Math.min(chosen, from.current.size()) : 0;
  }

  /**
   * Makes a known goal the only current one; the mission continues from there, and finished goals
   * are reopened.
   */
  void changeTo(String uid) {
    changeTo(List.of(uid));
  }

  /** Like {@link #changeTo(String)} for several goals from which the planner chooses. */
  void changeTo(Collection<String> uids) {
    at = new Position();
    at.current.addAll(uids);
    pursuedMicros.keySet().retainAll(uids);
    uids.forEach(book::renew);
  }

  /** Current position, for {@link #backTo}. */
  Position position() {
    return new Position(at);
  }

  void backTo(Position before) {
    at = new Position(before);
    at.current.forEach(book::renew);
  }

  /** Ends the sequence: no goal is current. */
  void end() {
    at = new Position();
    pursuedMicros.clear();
    endLoop();
  }

  /** Makes the current lap the last. */
  void endLoop() {
    loop = false;
  }

  /**
   * Merges the set fields of an update; an unknown goal is added, but no goal leads to it.
   *
   * @return whether it was known
   */
  boolean update(GoalInformation update) {
    return book.update(update);
  }

  /** Whether the followers of the current goals depend on more than their own fields. */
  boolean isInTheMiddleOfOptions() {
    return at.wanted > 0 || !at.pending.isEmpty();
  }

  /**
   * The goals whose followers become current together with those of a goal, including that goal.
   */
  Set<String> together(String uid) {
    Set<String> together = new LinkedHashSet<>(List.of(uid));
    boolean all = options == Options.ALL;
    if (at.current.contains(uid) && (all || at.wanted > 0)) {
      together.addAll(at.current);
    }
    for (String name : book.names()) {
      List<String> next = followers.usual(name);
      if (next.contains(uid) && (all || book.goal(name).choose().isPresent())) {
        together.addAll(next);
      }
    }
    return together;
  }

  /** Postpones some of the current goals' followers until after others. */
  void postpone(List<String> uids) {
    uids.forEach(at.pending::remove);
  }

  /** Pursues a goal before the current goals, which follow by its {@code next}. */
  void putBefore(String uid) {
    at.current.clear();
    at.current.add(uid);
    at.finished.remove(uid);
    pursuedMicros.keySet().retainAll(at.current);
  }

  /** Adds to the time for which the current goals were pursued [µs]. */
  void pursuedFor(long micros) {
    at.current.forEach(uid -> pursuedMicros.merge(uid, micros, Long::sum));
    pursuedMicros.keySet().retainAll(at.current);
  }

  /**
   * A current goal whose time limit has expired. This always takes some time, however short the
   * limit, because a loop of goals that expire immediately would not terminate.
   */
  Optional<GoalInformation> timedOut() {
    return current().stream()
        .filter(goal -> goal.timeLimit().isPresent())
        .filter(
            goal ->
                pursuedMicros.getOrDefault(goal.uid(), 0L)
                    >= Math.max(1L, Clock.micros(goal.timeLimit().getAsDouble())))
        .findFirst();
  }
}
