package org.u2sa.mission;

import java.util.Optional;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.log.Logger;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.service.handover.HandOver;

/**
 * Enforces time limits of goals and the mission. Their clock runs while the vehicle is armed, or
 * always if the arming state is unknown. Confined to the manager's thread.
 */
final class TimeLimits {
  private static final long NEVER = -1;

  private final MissionRun run;
  private final Logger logger;
  private long lastMicros = NEVER;
  private boolean stands; // disarmed

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
    boolean resumes = stands && armed;
    stands = !armed;
    return resumes;
  }

  /** Whether no time is counted, because the vehicle is disarmed. */
  boolean stands() {
    return stands;
  }

  /**
   * Advances to the current time.
   *
   * @return whether the current goals changed
   */
  boolean pass() {
    MissionProgress progress = run.progress();
    long now = run.micros();
    progress.pursuedFor(sinceLast(now), now);
    boolean changed = false;
    Optional<GoalInformation> late = progress.pursued().timedOut();
    while (late.isPresent()) {
      changed = true;
      timeOut(late.get(), "not done within " + late.get().timeLimit().getAsDouble() + " s");
      late = progress.pursued().timedOut();
    }
    if (progress.passes(run.mission().timeLimit())) {
      changed |= end(progress.pursued(), run.mission().limit().orElseThrow());
    }
    return changed;
  }

  private long sinceLast(long nowMicros) {
    long counted = lastMicros == NEVER || stands ? 0 : Math.max(0, nowMicros - lastMicros);
    lastMicros = nowMicros;
    return counted;
  }

  private void timeOut(GoalInformation goal, String reason) {
    logger.log(LogLevelEnum.WARN, "goal \"" + goal.uid() + "\" timed out: " + reason);
    run.progress().finish(goal.uid(), GoalResult.TIMED_OUT, Optional.empty(), reason, run.micros());
  }

  /** Returns whether the current goals changed. */
  private boolean end(GoalSequence mission, MissionLimit limit) {
    String reason = "the mission's time limit of " + limit.seconds() + " s has passed";
    if (limit.next().containsAll(mission.currentNames())) {
      mission.endLoop();
      logger.log(LogLevelEnum.INFO, reason + ": " + mission.currentNames() + " continues");
      return false;
    }
    logger.log(LogLevelEnum.WARN, reason + (limit.next().isEmpty() ? "" : ": now " + limit.next()));
    mission.current().forEach(goal -> timeOut(goal, reason));
    mission.end();
    if (!limit.next().isEmpty()) {
      mission.changeTo(limit.next());
    }
    return true;
  }

  void handOver(HandOver state) {
    state.flag("TIME STANDS", stands);
    if (lastMicros != NEVER) {
      state.number("TIME", Clock.seconds(lastMicros));
    }
  }

  /** Restores the clock; the time between two Mission Managers counts. */
  void takeOver(HandOver state) {
    stands = state.flag("TIME STANDS");
    state.number("TIME").ifPresent(seconds -> lastMicros = Clock.micros(seconds));
  }
}
