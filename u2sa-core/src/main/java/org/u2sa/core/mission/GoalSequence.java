package org.u2sa.core.mission;

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
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.GoalResult;
import org.u2sa.service.HandOver;

/**
 * The order in which the goals of a mission become current (thesis 3.2.3.2, 3.2.3.3): {@link
 * Followers} says what follows a goal, this class what that means for the goals beside it.
 *
 * <p>A goal that is finished does not become current again, unless all that could follow are
 * finished: then a new lap begins. Belongs to one thread.
 */
final class GoalSequence {
  /** What becomes of several goals that are current at the same time. */
  enum Options {
    /** All are to be finished, in whatever order, before what follows them. */
    ALL,
    /** One is to be finished; its {@code next} names what follows. */
    ANY
  }

  private final GoalBook book;
  private final Followers followers;
  private final String first;
  private final Map<String, Long> pursuedMicros = new LinkedHashMap<>(); // by current goal
  private Position at;
  private boolean loop;
  private Options options;

  /**
   * @param goals at least one, with unique names; the first is where the mission begins
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

  /** Writes down how far it is, under a name, for a Mission Manager that takes over. */
  void handOver(HandOver state, String name) {
    book.handOver(state, name);
    at.handOver(state, name);
    state
        .texts(name + " ORDER", followers.order())
        .texts(name + " PURSUED TIMES", Position.texts(pursuedMicros))
        .text(name + " FIRST", first);
  }

  /** The sequence that was handed over under a name, as far as it was; empty if there is none. */
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

  /** Changes how the mission goes on from here. */
  void rules(boolean newLoop, Options newOptions) {
    loop = newLoop;
    options = newOptions;
  }

  /** All its goals, as they are now. */
  GoalBook book() {
    return book;
  }

  /** What follows each goal. */
  Followers followers() {
    return followers;
  }

  /** The current goals; none if the mission is over. */
  List<GoalInformation> current() {
    return book.named(at.current);
  }

  /** The names of the goals to be pursued now. */
  Set<String> currentNames() {
    return Collections.unmodifiableSet(at.current);
  }

  /**
   * What becomes current after one of the current goals, as {@link
   * org.u2sa.messages.GoalList#upcoming} has it.
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

  boolean knows(String uid) {
    return book.knows(uid);
  }

  boolean isOver() {
    return at.current.isEmpty();
  }

  /** {@link #finish(String, GoalResult, Optional, String, long)} of a goal that was reached. */
  boolean finish(String uid) {
    return finish(uid, GoalResult.DONE, Optional.empty(), "", 0);
  }

  /**
   * Goes on from a goal that was completed or given up.
   *
   * @param report the Path Planner's; empty if there is none
   * @param reason why it was given up; empty if it was not, or if the report says so
   * @param micros the time now [µs of the run's clock]
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

  /** Moves a position on from a current goal. */
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
   * Makes a known goal the only current one; the mission goes on from there, and finished goals are
   * open again.
   */
  void changeTo(String uid) {
    changeTo(List.of(uid));
  }

  /** {@link #changeTo(String)} with several of which the planner chooses. */
  void changeTo(Collection<String> uids) {
    at = new Position();
    at.current.addAll(uids);
    pursuedMicros.keySet().retainAll(uids);
    uids.forEach(book::renew);
  }

  /** How far it is, to come back to. */
  Position position() {
    return new Position(at);
  }

  /** Goes back to where it was. */
  void backTo(Position before) {
    at = new Position(before);
    at.current.forEach(book::renew);
  }

  /** Ends: no goal is current any more. */
  void end() {
    at = new Position();
    pursuedMicros.clear();
    loop = false;
  }

  /**
   * Takes over the fields that are set in an update; a goal that is not known is added, but nothing
   * leads to it.
   *
   * @return whether it was known
   */
  boolean update(GoalInformation update) {
    return book.update(update);
  }

  /** Whether what follows the current goals depends on more than their own fields. */
  boolean isInTheMiddleOfOptions() {
    return at.wanted > 0 || !at.pending.isEmpty();
  }

  /** Pursues a goal before the current ones, which its {@code next} names. */
  void putBefore(String uid) {
    at.current.clear();
    at.current.add(uid);
    at.finished.remove(uid);
    pursuedMicros.keySet().retainAll(at.current);
  }

  /** Takes note that the current goals were pursued for another while [µs]. */
  void pursuedFor(long micros) {
    at.current.forEach(uid -> pursuedMicros.merge(uid, micros, Long::sum));
    pursuedMicros.keySet().retainAll(at.current);
  }

  /**
   * A current goal whose time limit has passed. Whatever the limit, that takes some time: a loop of
   * goals without any would never end.
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
