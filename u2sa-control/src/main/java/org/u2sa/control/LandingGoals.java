package org.u2sa.control;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Landing;

/**
 * Refuses landings that a control cannot fly, when they begin: reports them as abandoned, so that
 * the mission goes on. One that could be flown when it began is never refused.
 */
public final class LandingGoals {
  private static final long JUDGED_MICROS = 3 * Clock.MICROS_PER_SECOND; // without interruption

  private Optional<GoalInformation> current = Optional.empty();
  private boolean isJudged;
  private long sinceMicros;

  /** Processes the current goals. */
  public void see(GoalList goals, long nowMicros) {
    Optional<GoalInformation> next =
        goals.goals().stream().filter(Landing.class::isInstance).findFirst();
    if (!next.map(GoalInformation::uid).equals(current.map(GoalInformation::uid))) {
      isJudged = false;
      sinceMicros = nowMicros;
    }
    current = next;
  }

  /**
   * The report that refuses the current landing, once.
   *
   * @param cannot why the control cannot land at present; empty if it can
   */
  public Optional<GoalInformation> refused(Optional<String> cannot, long nowMicros) {
    if (current.isEmpty() || isJudged) {
      return Optional.empty();
    }
    isJudged = cannot.isEmpty() || nowMicros - sinceMicros > JUDGED_MICROS;
    if (cannot.isEmpty() || !isJudged) {
      return Optional.empty();
    }
    GoalInformation report = current.get().copy().abandoned(true);
    report.timestamp(nowMicros);
    return Optional.of(report.reason("refused by the control: " + cannot.get()));
  }
}
