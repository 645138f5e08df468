package org.u2sa.mission;

import java.util.Optional;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.service.handover.HandOver;

/** Enforces time limits of goals and the mission. Confined to the manager's thread. */
final class TimeLimits {
  private final MissionManager manager;
  private final MissionTime time = new MissionTime();

  TimeLimits(MissionManager manager) {
    this.manager = manager;
  }

  /**
   * Starts or stops counting.
   *
   * @return whether it was stopped and runs again
   */
  boolean count(boolean armed) {
    return time.counts(armed);
  }

  /**
   * Advances to the current time.
   *
   * @return whether the current goals changed
   */
  boolean pass() {
    MissionProgress progress = manager.progress();
    long now = manager.micros();
    progress.pursuedFor(time.sinceLast(now), now);
    boolean changed = false;
    Optional<GoalInformation> late = progress.pursued().timedOut();
    while (late.isPresent()) {
      changed = true;
      timeOut(late.get(), "not done within " + late.get().timeLimit().getAsDouble() + " s");
      late = progress.pursued().timedOut();
    }
    if (progress.passes(manager.mission().timeLimit())) {
      changed = true;
      end(progress.pursued(), manager.mission().limit().orElseThrow());
    }
    return changed;
  }

  private void timeOut(GoalInformation goal, String reason) {
    manager.log(LogLevelEnum.WARN, "goal \"" + goal.uid() + "\" timed out: " + reason);
    manager
        .progress()
        .finish(goal.uid(), GoalResult.TIMED_OUT, Optional.empty(), reason, manager.micros());
  }

  private void end(GoalSequence mission, MissionLimit limit) {
    String reason = "the mission's time limit of " + limit.seconds() + " s has passed";
    manager.log(
        LogLevelEnum.WARN, reason + (limit.next().isEmpty() ? "" : ": now " + limit.next()));
    mission.current().forEach(goal -> timeOut(goal, reason));
    mission.end();
    if (!limit.next().isEmpty()) {
      mission.changeTo(limit.next());
    }
  }

  void handOver(HandOver state) {
    time.handOver(state);
  }

  void takeOver(HandOver state) {
    time.takeOver(state);
  }
}
