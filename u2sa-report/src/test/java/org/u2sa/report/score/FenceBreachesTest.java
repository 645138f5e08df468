package org.u2sa.report.score;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class FenceBreachesTest {
  private static final List<RunPlan.Corner> SQUARE =
      List.of(
          new RunPlan.Corner(179.9, 0.0),
          new RunPlan.Corner(-179.9, 0.0),
          new RunPlan.Corner(-179.9, 0.2),
          new RunPlan.Corner(179.9, 0.2));

  private static final List<RunPlan.Corner> KEEP_OUT =
      List.of(
          new RunPlan.Corner(179.99, 0.05),
          new RunPlan.Corner(-179.99, 0.05),
          new RunPlan.Corner(-179.99, 0.15),
          new RunPlan.Corner(179.99, 0.15));

  private static final RunPlan PLAN =
      new RunPlan(Domain.GROUND, Optional.empty(), List.of()).within(SQUARE, List.of());

  private static List<TrackSample> track(double... longitudes) {
    return IntStream.range(0, longitudes.length)
        .mapToObj(
            i ->
                new TrackSample(
                    i,
                    longitudes[i],
                    0.1,
                    0.0,
                    0.0,
                    1.0,
                    OptionalDouble.empty(),
                    0,
                    "DRIVES",
                    Optional.empty()))
        .toList();
  }

  @Test
  void count_trackThatStaysInsideOverTheDateLine_isNone() {
    assertThat(FenceBreaches.count(PLAN, track(179.95, 180.0, -179.95))).isZero();
  }

  @Test
  void count_trackThatLeavesTwice_isTwo() {
    assertThat(FenceBreaches.count(PLAN, track(179.95, 179.8, 179.8, 179.95, 179.8))).isEqualTo(2);
  }

  @Test
  void count_trackThroughAKeepOutArea_isOneForEachTime() {
    RunPlan plan = PLAN.within(SQUARE, List.of(KEEP_OUT));
    assertThat(FenceBreaches.count(plan, track(179.95, 180.0, -179.95, -179.995, 179.95)))
        .isEqualTo(2);
    assertThat(FenceBreaches.count(plan, track(179.95, 179.96, 179.97))).isZero();
  }

  @Test
  void score_keepOutAreaWithoutKeepInArea_countsWhatEntersIt() {
    RunPlan plan = PLAN.within(List.of(), List.of(KEEP_OUT));
    assertThat(
            RunScorer.score(plan, track(179.5, 180.0, 179.5), RunOutcome.clean())
                .outcome()
                .counts())
        .containsEntry("fenceBreaches", 1);
  }
}
