package org.u2sa.report.score;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class FenceBreachesTest {
  private static final double LATITUDE_DEG = 0.1;

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

  private final FenceBreaches breaches = new FenceBreaches();

  private void drive(
      List<RunPlan.Corner> keepIn, List<List<RunPlan.Corner>> keepOuts, double... longitudes) {
    for (double longitude : longitudes) {
      breaches.see(keepIn, keepOuts, longitude, LATITUDE_DEG);
    }
  }

  private void requireCounted(int count) {
    assertThat(breaches.countedIn(RunOutcome.clean()).counts())
        .containsEntry("fenceBreaches", count);
  }

  @Test
  void see_trackThatStaysInsideOverTheDateLine_isNone() {
    drive(SQUARE, List.of(), 179.95, 180.0, -179.95);
    requireCounted(0);
  }

  @Test
  void see_trackThatLeavesTwice_isTwo() {
    drive(SQUARE, List.of(), 179.95, 179.8, 179.8, 179.95, 179.8);
    requireCounted(2);
  }

  @Test
  void see_trackThroughAKeepOutArea_isOneForEachTime() {
    drive(SQUARE, List.of(KEEP_OUT), 179.95, 180.0, -179.95, -179.995, 179.95);
    requireCounted(2);
  }

  @Test
  void see_trackBesideAKeepOutArea_isNone() {
    drive(SQUARE, List.of(KEEP_OUT), 179.95, 179.96, 179.97);
    requireCounted(0);
  }

  @Test
  void see_keepOutAreaWithoutKeepInArea_countsWhatEntersIt() {
    drive(List.of(), List.of(KEEP_OUT), 179.5, 180.0, 179.5);
    requireCounted(1);
  }

  @Test
  void see_keepOutAreaLiftedAfterwards_stillCounts() {
    drive(SQUARE, List.of(KEEP_OUT), 179.95, 180.0, -179.95);
    drive(List.of(), List.of(), 180.0, 179.5);
    requireCounted(1);
  }

  @Test
  void see_keepOutAreaWhereItWasBefore_isNone() {
    drive(List.of(), List.of(), 180.0, -179.95);
    drive(SQUARE, List.of(KEEP_OUT), -179.95, -179.96);
    requireCounted(0);
  }

  @Test
  void countedIn_noFence_isAbsent() {
    drive(List.of(), List.of(), 180.0);
    assertThat(breaches.countedIn(RunOutcome.clean()).counts()).isEmpty();
  }
}
