package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;

/** Reports of a planner whose Mission Manager does not react; repeated after 100 µs. */
class GoalReportsTest {
  private final List<GoalInformation> sent = new ArrayList<>();
  private final GoalReports reports = new GoalReports(sent::add, () -> 100L);
  private final GoalInformation goal = new Waypoint().uid("1");

  @Test
  void report_completed_onceWithItsTimeThenAgainAfterTheInterval() {
    Plan done = new Plan(List.of(), Plan.Progress.COMPLETED, "reached");
    reports.report(goal, done, 1000L);
    reports.report(goal, done, 1099L);

    assertThat(sent).hasSize(1);
    assertThat(sent.get(0).completed()).isTrue();
    assertThat(sent.get(0).timestamp()).hasValue(1000L);
    assertThat(reports.areOf("1")).isTrue();

    reports.report(goal, done, 1100L);
    assertThat(sent).hasSize(2);
    assertThat(sent.get(1)).isSameAs(sent.get(0));
  }

  @Test
  void report_abandoned_namesTheReason() {
    reports.report(goal, Plan.unless(Optional.of("a wall"), List.of()), 0L);

    assertThat(sent.get(0).abandoned()).isTrue();
    assertThat(sent.get(0).reason()).contains("given up: a wall");
  }

  @Test
  void forget_sameGoalAgain_isReportedAgain() {
    Plan done = new Plan(List.of(), Plan.Progress.COMPLETED, "");
    reports.report(goal, done, 0L);
    reports.forget();

    assertThat(reports.last()).isEmpty();
    reports.report(goal, done, 1L);
    assertThat(sent).hasSize(2);
  }
}
