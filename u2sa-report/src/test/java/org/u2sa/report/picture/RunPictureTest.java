package org.u2sa.report.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunDetails;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.RunScore;
import org.u2sa.report.score.RunScorer;
import org.u2sa.report.score.TrackSample;
import org.u2sa.report.score.WaypointResult;

class RunPictureTest {
  private static final RunPlan.Waypoint PLACE =
      new RunPlan.Waypoint("a", 8.0, 50.0, OptionalDouble.empty(), 1.0, OptionalDouble.empty());
  private static final RunPlan PLAN = new RunPlan(Domain.WATER, Optional.empty(), List.of(PLACE));

  private static TrackSample sample(OptionalDouble crossTrackM) {
    return new TrackSample(0.0, 8.0, 50.0, 0.0, 0.0, 1.5, crossTrackM, 0, "", Optional.empty());
  }

  @Test
  void overTime_neverOnALine_showsTheSpeed() {
    Quantity shown = Quantity.overTime(PLAN, List.of(sample(OptionalDouble.empty())));

    assertThat(shown.name()).isEqualTo("speed over ground");
  }

  @Test
  void overTime_largeDeviation_fits() {
    TrackSample far = sample(OptionalDouble.of(-88.0));
    Quantity shown = Quantity.overTime(PLAN, List.of(far, sample(OptionalDouble.empty())));

    assertThat(shown.low()).isLessThanOrEqualTo(-88.0);
    assertThat(shown.of().applyAsDouble(far)).isEqualTo(-88.0);
    assertThat(shown.of().applyAsDouble(sample(OptionalDouble.empty()))).isNaN();
  }

  private static WaypointResult result(boolean captured) {
    return new WaypointResult(
        PLACE, OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty(), captured);
  }

  @Test
  void of_capturedInSomeLaps_isNeitherCapturedNorMissed() {
    List<WaypointSign> signs = WaypointSign.of(List.of(result(false), result(true), result(false)));

    assertThat(signs).hasSize(1);
    assertThat(signs.get(0).captured()).isFalse();
    assertThat(signs.get(0).missed()).isFalse();
    assertThat(signs.get(0).share()).isEqualTo(" (1 of 3 times)");
  }

  private static String alarm(RunOutcome outcome, List<String> interventions) {
    List<TrackSample> track = List.of(sample(OptionalDouble.empty()));
    RunScore score = RunScorer.score(PLAN, track, outcome);
    RunDetails facts =
        new RunDetails(
            "ferry", 7, "embedded", 1.0, OptionalInt.of(2), OptionalInt.of(1), interventions);
    return TrackPicture.alarm(facts, score);
  }

  @Test
  void alarm_violation_isNamed() {
    RunOutcome outcome = new RunOutcome(0, false, List.of("goal \"buoy\" was not completed"));

    assertThat(alarm(outcome, List.of("failsafe LAND because of geofence")))
        .contains("goal \"buoy\" was not completed", "failsafe LAND because of geofence");
  }

  @Test
  void alarm_success_isEmpty() {
    assertThat(alarm(RunOutcome.clean(), List.of("failsafe HOLD because of link"))).isEmpty();
  }
}
