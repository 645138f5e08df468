package org.u2sa.control.ground;

import org.u2sa.messages.goal.GoalList;

/**
 * Keeps a vehicle where a drive by hand ended until its mission is known to be paused: if no
 * Mission Manager runs, the goals of before the drive would lead it away as soon as the driver lets
 * go.
 */
final class HoldAfterDrive {
  private static final long SETTLED_MICROS = 500_000; // a Mission Manager that starts then pauses
  private static final long HEARD_MICROS = 1_000_000; // after which planners have heard the pause

  private boolean isPaused; // according to the newest goals
  private boolean isDriven;
  private boolean isAwaited; // a pause, during or since a drive
  private long endedMicros; // of the drive
  private long newGoalsMicros; // when goals arrived that were sent after the drive; 0: none
  private long heardMicros = Long.MIN_VALUE; // until then, planners may lead on as before the pause

  void begin() {
    isDriven = true;
    isAwaited = !isPaused;
  }

  void see(GoalList goals, long nowMicros) {
    isPaused = goals.paused();
    if (isPaused && isAwaited && !isDriven) {
      heardMicros = nowMicros + HEARD_MICROS;
    }
    isAwaited = !isPaused && (isDriven || isAwaited);
    boolean isNew = goals.timestamp().orElse(nowMicros) > endedMicros; // not retained
    if (isAwaited && !isDriven && newGoalsMicros == 0L && isNew) {
      newGoalsMicros = nowMicros;
    }
  }

  /**
   * Whether the vehicle, no longer driven, must stand. Ends a second after the mission is known to
   * be paused or, if its service does not pause, half a second after it has sent goals again.
   */
  boolean holds(long nowMicros) {
    if (isDriven) {
      isDriven = false;
      endedMicros = nowMicros;
      newGoalsMicros = 0L;
    }
    isAwaited &= newGoalsMicros == 0L || nowMicros - newGoalsMicros <= SETTLED_MICROS;
    return isAwaited || nowMicros < heardMicros;
  }

  boolean isAwaited() {
    return isAwaited;
  }

  /** Continues for a predecessor whose drive has ended. */
  void await(boolean predecessors, long nowMicros) {
    isAwaited = predecessors;
    endedMicros = nowMicros;
  }
}
