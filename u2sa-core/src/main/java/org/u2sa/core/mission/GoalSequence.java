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
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.service.HandOver;

/**
 * The order in which the goals of a mission become current (thesis 3.2.3.2, 3.2.3.3).
 *
 * <p>A goal is followed by those that its {@code next} names. If no goal of the mission has a
 * {@code next}, each is followed by the one after it. A goal that is finished does not become
 * current again, unless all that could follow are finished: then a new lap begins. Belongs to one
 * thread.
 */
final class GoalSequence {
  /** What becomes of several goals that are current at the same time. */
  enum Options {
    /** All are to be finished, in whatever order, before what follows them. */
    ALL,
    /** One is to be finished; what follows is what that one's {@code next} names. */
    ANY
  }

  private final Map<String, GoalInformation> goals = new LinkedHashMap<>();
  private final List<String> order = new ArrayList<>(); // empty if the mission is linked by next
  private final Set<String> current = new LinkedHashSet<>();
  private final Set<String> pending =
      new LinkedHashSet<>(); // ALL: what follows once current is empty
  private final Set<String> finished = new LinkedHashSet<>(); // in this lap
  private final String first;
  private boolean loop;
  private Options options;

  /**
   * @param goals at least one, with unique names; the first is where the mission begins
   * @param loop whether the mission begins anew when no goal is left
   */
  GoalSequence(List<GoalInformation> goals, boolean loop, Options options) {
    goals.forEach(goal -> this.goals.put(goal.uid(), goal));
    if (goals.stream().allMatch(goal -> goal.next().isEmpty())) {
      order.addAll(this.goals.keySet());
    }
    this.loop = loop;
    this.options = options;
    first = goals.get(0).uid();
    current.add(first);
  }

  private GoalSequence(GoalSequence other) {
    goals.putAll(other.goals);
    order.addAll(other.order);
    current.addAll(other.current);
    pending.addAll(other.pending);
    finished.addAll(other.finished);
    first = other.first;
    loop = other.loop;
    options = other.options;
  }

  /** Writes down how far it is, under a name, for a Mission Manager that takes over. */
  void handOver(HandOver state, String name) {
    state
        .messages(name + " GOALS", goals.values())
        .texts(name + " ORDER", order)
        .texts(name + " CURRENT", current)
        .texts(name + " PENDING", pending)
        .texts(name + " FINISHED", finished)
        .text(name + " FIRST", first);
  }

  /** The sequence that was handed over under a name, as far as it was; empty if there is none. */
  static Optional<GoalSequence> takenOver(
      HandOver state, String name, boolean loop, Options options) {
    List<GoalInformation> goals = state.messages(name + " GOALS", GoalInformation.class);
    return goals.isEmpty()
        ? Optional.empty()
        : Optional.of(new GoalSequence(state, name, goals, loop, options));
  }

  private GoalSequence(
      HandOver state, String name, List<GoalInformation> goals, boolean loop, Options options) {
    goals.forEach(goal -> this.goals.put(goal.uid(), goal));
    order.addAll(state.texts(name + " ORDER"));
    current.addAll(state.texts(name + " CURRENT"));
    pending.addAll(state.texts(name + " PENDING"));
    finished.addAll(state.texts(name + " FINISHED"));
    first = state.text(name + " FIRST").orElseGet(() -> goals.get(0).uid());
    this.loop = loop;
    this.options = options;
  }

  /** Changes how the mission goes on from here. */
  void rules(boolean newLoop, Options newOptions) {
    loop = newLoop;
    options = newOptions;
  }

  /** The goals to be pursued now; none if the mission is over. */
  List<GoalInformation> current() {
    return named(current);
  }

  /**
   * What becomes current after one of the current goals, as {@link
   * org.u2sa.messages.GoalList#upcoming} has it.
   */
  List<GoalInformation> upcoming() {
    if (current.size() == 1) {
      GoalSequence ahead = new GoalSequence(this);
      ahead.finish(current.iterator().next());
      return ahead.current();
    }
    Set<String> next = new LinkedHashSet<>();
    if (options == Options.ANY) {
      current.forEach(name -> next.addAll(followers(name)));
      next.removeAll(finished);
    }
    return named(next);
  }

  private List<GoalInformation> named(Collection<String> names) {
    List<GoalInformation> list = new ArrayList<>();
    names.forEach(name -> list.add(goals.get(name)));
    return list;
  }

  boolean knows(String uid) {
    return goals.containsKey(uid);
  }

  boolean isOver() {
    return current.isEmpty();
  }

  /**
   * Goes on from a goal that was completed or given up.
   *
   * @return false if the goal is not current
   */
  boolean finish(String uid) {
    if (!current.remove(uid)) {
      return false;
    }
    finished.add(uid);
    List<String> followers = followers(uid);
    if (options == Options.ALL) {
      pending.addAll(followers);
      if (current.isEmpty()) {
        open(new ArrayList<>(pending));
        pending.clear();
      }
    } else if (!followers.isEmpty()) {
      open(followers);
    }
    if (current.isEmpty() && loop) {
      open(Collections.singletonList(first));
    }
    return true;
  }

  private List<String> followers(String uid) {
    List<String> next = goals.get(uid).next();
    int place = order.indexOf(uid);
    if (!next.isEmpty() || place < 0 || place + 1 == order.size()) {
      List<String> known = new ArrayList<>(next);
      known.retainAll(goals.keySet()); // an update may name goals that are still to come
      return known;
    }
    return Collections.singletonList(order.get(place + 1));
  }

  private void open(List<String> names) {
    current.clear();
    current.addAll(names);
    current.removeAll(finished);
    if (current.isEmpty()) { // a new lap
      finished.clear();
      current.addAll(names);
    }
  }

  /**
   * Makes a known goal the only current one; the mission goes on from there, and finished goals are
   * open again.
   */
  void changeTo(String uid) {
    finished.clear();
    pending.clear();
    current.clear();
    current.add(uid);
  }

  /**
   * Takes over the fields that are set in an update; a goal that is not known is added, but nothing
   * leads to it.
   *
   * @return whether it was known
   */
  boolean update(GoalInformation update) {
    GoalInformation known = goals.get(update.uid());
    GoalInformation merged =
        known != null && known.type() == update.type()
            ? merged(known.copy(), update, update.type())
            : update.copy();
    merged.freeze();
    goals.put(merged.uid(), merged);
    return known != null;
  }

  @SuppressWarnings("unchecked") // both are of the type
  private static <T extends GoalInformation> GoalInformation merged(
      GoalInformation into, GoalInformation from, MessageType<?> type) {
    for (MessageField<?> each : type.fields()) {
      MessageField<GoalInformation> field = (MessageField<GoalInformation>) each;
      if (field.isSet(from)) {
        field.set(into, field.get(from).orElseThrow());
      }
    }
    return into;
  }
}
