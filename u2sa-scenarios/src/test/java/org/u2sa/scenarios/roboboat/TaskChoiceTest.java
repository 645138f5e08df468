package org.u2sa.scenarios.roboboat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.mission.Mission;

class TaskChoiceTest {
  @TempDir private Path directory;

  private BoatTask task(String fields) throws IOException {
    Path file = directory.resolve("mission.xml");
    Files.writeString(
        file,
        "<mission><findTarget><x>-82.45</x><y>27.37</y>" + fields + "</findTarget></mission>");
    return (BoatTask) Mission.load(file).goals().get(0);
  }

  @Test
  void costS_likelierTask_isCheaper() throws IOException {
    BoatTask likely =
        task("<expectedTime>20</expectedTime><successProbability>1</successProbability>");
    BoatTask unlikely =
        task("<expectedTime>20</expectedTime><successProbability>0.5</successProbability>");

    assertThat(TaskChoice.costS(likely, 16.0, 0.0)).isEqualTo(40.0);
    assertThat(TaskChoice.costS(unlikely, 16.0, 0.0)).isEqualTo(80.0);
  }

  @Test
  void costS_nearerButLongerTask_isDearer() throws IOException {
    assertThat(TaskChoice.costS(task("<expectedTime>60</expectedTime>"), 8.0, 0.0))
        .isGreaterThan(TaskChoice.costS(task("<expectedTime>10</expectedTime>"), 24.0, 0.0));
  }

  @Test
  void costS_wouldEndTooLateToGetHome_isInfinite() throws IOException {
    BoatTask task = task("<expectedTime>20</expectedTime><endBy>900</endBy>");

    assertThat(TaskChoice.costS(task, 16.0, 859.0)).isEqualTo(40.0);
    assertThat(TaskChoice.costS(task, 16.0, 861.0)).isInfinite();
  }

  @Test
  void costS_fallback_liesBetweenTheDearestTaskAndOneThatIsTooLate() throws IOException {
    double fallback = TaskChoice.costS(task("<fallback>true</fallback>"), 1.0, 1_000.0);

    assertThat(fallback).isFinite();
    assertThat(fallback)
        .isGreaterThan(
            TaskChoice.costS(
                task(
                    "<expectedTime>500</expectedTime><successProbability>0.1</successProbability>"),
                500.0,
                0.0));
  }
}
