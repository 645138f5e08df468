package org.u2sa.mission;

import java.util.Optional;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.log.Logger;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.service.handover.HandOver;

/** Enforces time limits of goals and the mission. Confined to the manager's thread. */
final class TimeLimits {
  private final MissionRun run;
  private final Logger logger;
  private final MissionTime time = new MissionTime();

  TimeLimits(MissionRun run, Logger logger) {
    this.run = run;
    this.logger = logger;
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
    MissionProgress progress = run.progress();
    long now = run.micros();
    progress.pursuedFor(time.sinceLast(now), now);
    boolean changed = false;
    Optional<GoalInformation> late = progress.pursued().timedOut();
    while (late.isPresent()) {
      changed = true;
      timeOut(late.get(), "not done within " + late.get().timeLimit().getAsDouble() + " s");
      late = progress.pursued().timedOut();
    }
    if (progress.passes(run.mission().timeLimit())) {
      changed = true;
      end(progress.pursued(), run.mission().limit().orElseThrow());
    }
    return changed;
  }

  private void timeOut(GoalInformation goal, String reason) {
    logger.log(LogLevelEnum.WARN, "goal \"" + goal.uid() + "\" timed out: " + reason);
    run.progress().finish(goal.uid(), GoalResult.TIMED_OUT, Optional.empty(), reason, run.micros());
  }

  private void end(GoalSequence mission, MissionLimit limit) {
    String reason = "the mission's time limit of " + limit.seconds() + " s has passed";
    logger.log(LogLevelEnum.WARN, reason + (limit.next().isEmpty() ? "" : ": now " + limit.next()));
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
