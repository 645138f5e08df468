package org.u2sa.planning;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.planning.goals.MissionTime;
import org.u2sa.service.handover.HandOver;

/**
 * What a planner obeys: the goals of the Mission Manager, the failsafe in force, and a pilot who
 * drives by hand. Confined to the planner's thread.
 */
final class PlannerOrders {
  private static final long CLOCKS_APART_MICROS = Clock.MICROS_PER_SECOND; // at most

  private final MissionTime time = new MissionTime();
  private Optional<GoalList> goals = Optional.empty();
  // Goal list transferred by the predecessor; it arrives again because it is retained.
  private Optional<GoalList> takenOver = Optional.empty();
  private FailsafeAction failsafe = FailsafeAction.CONTINUE;
  private boolean hasFailsafe; // whether one was heard
  private long failsafeMicros; // when the present one began
  private boolean byHand; // navigation is currently ignored

  void handOver(HandOver state) {
    goals.ifPresent(list -> state.message("GOALS", list));
    time.handOver(state);
    state.text("FAILSAFE", failsafe.name());
  }

  void takeOver(HandOver state) {
    goals = state.message("GOALS", GoalList.class);
    takenOver = goals;
    time.takeOver(state);
    failsafe = state.text("FAILSAFE").map(FailsafeAction::valueOf).orElse(FailsafeAction.CONTINUE);
  }

  /**
   * Receives goals.
   *
   * @return whether they are news; retained ones were already handled by the previous planner
   */
  boolean heed(GoalList list, long nowMicros) {
    boolean known = takenOver.filter(list::equals).isPresent();
    takenOver = Optional.empty();
    if (!known) {
      goals = Optional.of(list);
      time.update(list, nowMicros);
    }
    return !known;
  }

  /**
   * Receives a failsafe.
   *
   * @return whether it differs from the one in force
   */
  boolean heed(FailsafeState state, long nowMicros) {
    boolean isFirst = !hasFailsafe; // of this planner: the answer may be older
    hasFailsafe = true;
    if (state.action() == failsafe) {
      return false;
    }
    failsafeMicros = isFirst ? 0L : state.timestamp().orElse(nowMicros);
    failsafe = state.action();
    return true;
  }

  void heed(ManualState state) {
    byHand = state.active();
  }

  Optional<GoalList> goals() {
    return goals;
  }

  FailsafeAction failsafe() {
    return failsafe;
  }

  boolean isByHand() {
    return byHand;
  }

  /** Whether there is a mission to pursue or a position to hold. */
  boolean isTasked() {
    return failsafe != FailsafeAction.STOP && (goals.isPresent() || isHolding());
  }

  /** Whether the goals lead home. */
  boolean isReturning() {
    return goals.filter(GoalList::returning).isPresent();
  }

  /** Time for which the mission has been pursued [s]. */
  double missionS(long nowMicros) {
    return time.elapsedS(nowMicros);
  }

  /** Whether to hold the position instead of pursuing goals. */
  boolean isHolding() {
    return failsafe == FailsafeAction.HOLD
        || goals.filter(GoalList::paused).isPresent()
        || goals.filter(this::leadOnDespiteFailsafe).isPresent();
  }

  /** RETURN and LAND are answered with other goals, unless no Mission Manager runs. */
  private boolean leadOnDespiteFailsafe(GoalList list) {
    boolean isWayBack = failsafe == FailsafeAction.RETURN || failsafe == FailsafeAction.LAND;
    return isWayBack
        && !list.returning()
        && !list.goals().isEmpty()
        && list.timestamp().orElse(Long.MAX_VALUE) < failsafeMicros - CLOCKS_APART_MICROS;
  }
}
