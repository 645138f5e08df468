package org.u2sa.report.score;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

class RunVerdictTest {
  private static String verdict(Map<String, Integer> counts) {
    return score(counts).verdict();
  }

  private static RunScore score(Map<String, Integer> counts) {
    return new RunScore(
        List.of(),
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        Optional.empty(),
        List.of(),
        new RunOutcome(0, false, List.of(), counts, Map.of()),
        10.0);
  }

  @Test
  void verdict_tasksButNoWaypoints_countsTasks() {
    assertThat(verdict(Map.of(RunOutcome.TASKS, 7, RunOutcome.TASKS_DONE, 5)))
        .isEqualTo("5 of 7 tasks done");
  }

  @Test
  void verdict_noTasks_countsWaypoints() {
    assertThat(verdict(Map.of())).isEqualTo("0 of 0 waypoints captured");
  }

  private static RunDetails details(int goals, int completed) {
    return new RunDetails(
        "boat", 1, "embedded", 1.0, OptionalInt.of(goals), OptionalInt.of(completed), List.of());
  }

  @Test
  void verdict_goalsThatAreNoWaypoints_areCounted() {
    assertThat(details(4, 3).verdict(score(Map.of()))).isEqualTo("3 of 4 goals completed");
  }

  @Test
  void verdict_tasks_replaceGoals() {
    RunScore score = score(Map.of(RunOutcome.TASKS, 7, RunOutcome.TASKS_DONE, 5));

    assertThat(details(4, 3).verdict(score)).isEqualTo("5 of 7 tasks done");
  }
}
