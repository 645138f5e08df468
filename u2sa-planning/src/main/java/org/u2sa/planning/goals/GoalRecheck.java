package org.u2sa.planning.goals;

import org.u2sa.interfaces.time.Clock;

/**
 * Whether to go nearer to a goal to which there is no way, before it is given up: what was seen
 * there may have left, which cannot be seen from afar. Confined to the planner's thread.
 */
public final class GoalRecheck {
  private static final int MAX_LOOKS = 2; // for each goal
  private static final long WAITS_MICROS = 3 * Clock.MICROS_PER_SECOND;
  private static final long NEVER = Long.MIN_VALUE;

  private enum Stage {
    NONE,
    SOUGHT,
    UNDER_WAY
  }

  private Stage stage = Stage.NONE;
  private int looks;
  private long noneSince = NEVER; // since when there is no way to the goal

  /** Starts with a goal. */
  public void begin() {
    looks = 0;
    wayFound();
  }

  /** A way to the goal itself was found. */
  public void wayFound() {
    stage = Stage.NONE;
    noneSince = NEVER;
  }

  /** No way to a place near the goal was found either. */
  public void fails() {
    looks = MAX_LOOKS;
    wayFound();
  }

  /**
   * Whether to seek a place near the goal from now on; called while there is no way to the goal.
   *
   * @param isFar whether such a place is clearly nearer than the vehicle
   */
  public boolean begins(boolean isFar, long micros) {
    noneSince = noneSince == NEVER ? micros : noneSince;
    boolean begins =
        stage == Stage.NONE && isFar && looks < MAX_LOOKS && micros - noneSince >= WAITS_MICROS;
    if (begins) {
      stage = Stage.SOUGHT;
    }
    return begins;
  }

  /** A way to a place near the goal was found. */
  public void starts() {
    stage = Stage.UNDER_WAY;
    looks++;
  }

  /** Whether a place near the goal is sought, instead of the goal. */
  public boolean isSought() {
    return stage == Stage.SOUGHT;
  }

  public boolean isUnderWay() {
    return stage == Stage.UNDER_WAY;
  }
}
