package org.u2sa.control.ground;

import org.u2sa.messages.goal.GoalList;

/**
 * Keeps a vehicle where a drive by hand ended until its mission is known to be paused: if no
 * Mission Manager runs, the goals of before the drive would lead it away as soon as the driver lets
 * go.
 */
final class HoldAfterDrive {
  private static final long SETTLED_MICROS = 500_000; // a Mission Manager that starts then pauses

  private boolean isPaused; // according to the newest goals
  private boolean isAwaited; // a pause, since a drive began
  private long endedMicros; // 0: still driven
  private long newGoalsMicros; // when goals arrived that were sent after the drive; 0: none

  void begin() {
    isAwaited = !isPaused;
    endedMicros = 0L;
    newGoalsMicros = 0L;
  }

  void see(GoalList goals, long nowMicros) {
    isPaused = goals.paused();
    isAwaited &= !isPaused;
    boolean isNew = goals.timestamp().orElse(nowMicros) > endedMicros; // not retained
    if (isAwaited && endedMicros != 0L && newGoalsMicros == 0L && isNew) {
      newGoalsMicros = nowMicros;
    }
  }

  /**
   * Whether the vehicle, no longer driven, must stand. Ends when the mission is paused or, if its
   * service does not pause, half a second after it has sent goals again.
   */
  boolean holds(long nowMicros) {
    endedMicros = endedMicros == 0L ? nowMicros : endedMicros;
    isAwaited &= newGoalsMicros == 0L || nowMicros - newGoalsMicros <= SETTLED_MICROS;
    return isAwaited;
  }

  boolean isAwaited() {
    return isAwaited;
  }

  /** Continues for a predecessor. */
  void await(boolean predecessors) {
    isAwaited = predecessors;
  }
}
