package org.u2sa.mission;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/**
 * The goals of a mission by name: each as defined, and in its current state with the Path Planner's
 * changes (thesis 4.2.1.3: shots fired, time of arrival). A goal pursued again is reset to its
 * definition. Not thread-safe.
 */
final class GoalBook {
  private static final List<String> KEPT =
      List.of(
          "uid",
          "next",
          "timeLimit",
          "choose",
          "nextIfDone",
          "nextIfFailed",
          "nextIfTimedOut",
          "repeatFrom",
          "repeatTimes"); // the order is up to the Mission Manager and may have changed

  /**
   * Maximum encoded size of all goals together [B]: {@link org.u2sa.messages.goal.GoalList}
   * contains them up to three times, within the codec's limit.
   */
  private static final int MAX_BYTES = 320 * 1_024;

  /** Part of it that goal updates may fill; the rest is reserved for operators' orders. */
  private static final int MAX_UPDATED_BYTES = MAX_BYTES / 4 * 3;

  private final Map<String, GoalInformation> defined = new LinkedHashMap<>();
  private final Map<String, GoalInformation> present = new LinkedHashMap<>();
  private final Map<String, Long> finished = new LinkedHashMap<>();

  GoalBook(Collection<? extends GoalInformation> goals) {
    goals.forEach(goal -> put(goal, goal));
  }

  private void put(GoalInformation definition, GoalInformation now) {
    defined.put(definition.uid(), definition);
    present.put(definition.uid(), now);
  }

  boolean knows(String uid) {
    return present.containsKey(uid);
  }

  /** Names in the order in which the goals were added. */
  List<String> names() {
    return new ArrayList<>(present.keySet());
  }

  /** Current state of the goal. */
  GoalInformation goal(String uid) {
    return present.get(uid);
  }

  /** Current state of the goals. */
  List<GoalInformation> named(Collection<String> names) {
    return names.stream().map(present::get).collect(Collectors.toList());
  }

  /** Number of times the goal was completed or abandoned. */
  long timesFinished(String uid) {
    return finished.getOrDefault(uid, 0L);
  }

  /** Resets a goal that is pursued again to its definition. */
  void renew(String uid) {
    present.put(uid, defined.get(uid));
  }

  /**
   * Records the result of a goal.
   *
   * @param report planner's report, whose fields replace those of the mission; empty if none
   * @param micros time of the result [µs of the run's clock]
   */
  void finish(
      String uid, GoalResult result, Optional<GoalInformation> report, String reason, long micros) {
    finished.merge(uid, 1L, Long::sum);
    GoalInformation before = present.get(uid);
    GoalInformation now =
        report
            .filter(each -> each.type() == before.type())
            .map(each -> merged(before.copy(), each, KEPT))
            .filter(this::hasRoomFor)
            .orElseGet(before::copy);
    boolean done = result == GoalResult.DONE;
    now.completed(done).abandoned(!done).result(result);
    if (done && now.arrivedAt().isEmpty()) {
      now.arrivedAt(report.map(U2SAData::timestamp).orElse(OptionalLong.empty()).orElse(micros));
    }
    if (!done && now.reason().isEmpty() && !reason.isEmpty()) {
      now.reason(reason);
    }
    now.freeze();
    present.put(uid, now);
  }

  /** Converts times of arrival from another process's clock to this run's [µs later]. */
  void shiftArrivals(long micros) {
    for (Map.Entry<String, GoalInformation> each : present.entrySet()) {
      GoalInformation goal = each.getValue();
      if (goal.arrivedAt().isPresent()) {
        GoalInformation shifted = goal.copy().arrivedAt(goal.arrivedAt().getAsLong() + micros);
        shifted.freeze();
        each.setValue(shifted);
      }
    }
  }

  /** Whether the goals would remain short enough to publish if an update were applied. */
  boolean hasRoomForUpdate(GoalInformation update) {
    return hasRoomFor(updated(defined.get(update.uid()), update))
        && hasRoomFor(updated(present.get(update.uid()), update));
  }

  /** What a goal would lack if an update were applied; empty if nothing. */
  Optional<String> lackAfter(GoalInformation update) {
    return WaypointRules.lack(updated(defined.get(update.uid()), update))
        .or(() -> WaypointRules.lack(updated(present.get(update.uid()), update)));
  }

  /** {@link #hasRoomForUpdate} for several updates that are applied together. */
  boolean hasRoomForUpdates(Collection<? extends GoalInformation> updates) {
    return hasRoomForUpdates(defined, updates) && hasRoomForUpdates(present, updates);
  }

  private static boolean hasRoomForUpdates(
      Map<String, GoalInformation> before, Collection<? extends GoalInformation> updates) {
    Map<String, GoalInformation> after = new LinkedHashMap<>(before);
    updates.forEach(update -> after.compute(update.uid(), (uid, known) -> updated(known, update)));
    long bytes = bytes(after);
    return bytes <= MAX_BYTES || bytes <= bytes(before); // even if the file is too long
  }

  private static long bytes(Map<String, GoalInformation> goals) {
    return goals.values().stream().mapToLong(goal -> goal.serialize().length).sum();
  }

  private boolean hasRoomFor(GoalInformation changed) {
    long bytes = changed.serialize().length;
    GoalInformation before = present.get(changed.uid());
    if (before != null && bytes <= before.serialize().length) {
      return true; // even if the mission's file is too long
    }
    for (GoalInformation goal : present.values()) {
      bytes += goal == before ? 0 : goal.serialize().length;
    }
    return bytes <= MAX_UPDATED_BYTES;
  }

  /**
   * Merges the set fields of an update; unknown goals are added.
   *
   * @return whether it was known
   */
  boolean update(GoalInformation update) {
    String uid = update.uid();
    boolean known = defined.containsKey(uid);
    put(updated(defined.get(uid), update), updated(present.get(uid), update));
    return known;
  }

  private static GoalInformation updated(GoalInformation known, GoalInformation update) {
    GoalInformation goal =
        known != null && known.type() == update.type()
            ? merged(known.copy(), update, Collections.emptyList())
            : update.copy();
    goal.freeze();
    return goal;
  }

  @SuppressWarnings("unchecked") // both have this type
  static <T extends GoalInformation> GoalInformation merged(
      GoalInformation into, GoalInformation from, Collection<String> except) {
    MessageType<?> type = from.type();
    for (MessageField<?> each : type.fields()) {
      MessageField<GoalInformation> field = (MessageField<GoalInformation>) each;
      if (field.isSet(from) && !except.contains(field.name())) {
        field.set(into, field.get(from).orElseThrow());
      }
    }
    return into;
  }

  void handOver(HandOver state, String name) {
    List<GoalInformation> changed = new ArrayList<>(defined.values());
    changed.removeIf(goal -> goal == present.get(goal.uid())); // unchanged, as most are
    state
        .messages(name + " GOALS", present.values())
        .messages(name + " DEFINED", changed)
        .texts(name + " TIMES", Position.texts(finished));
  }

  /** Restores the book saved under a name; empty if none. */
  static Optional<GoalBook> takenOver(HandOver state, String name) {
    List<GoalInformation> goals = state.messages(name + " GOALS", GoalInformation.class);
    if (goals.isEmpty()) {
      return Optional.empty();
    }
    GoalBook book = new GoalBook(goals);
    for (GoalInformation goal : state.messages(name + " DEFINED", GoalInformation.class)) {
      book.defined.put(goal.uid(), goal);
    }
    book.finished.putAll(Position.numbers(state.texts(name + " TIMES")));
    return Optional.of(book);
  }
}
