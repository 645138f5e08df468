package org.u2sa.scenarios.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.TrackSample;

/** Two waypoints, the second north of the first; the vehicle is about 10 m east of their line. */
class RunRecordTest {
  private static final double EAST_DEG = 9.0e-5;

  private final List<TrackSample> samples = new ArrayList<>();
  private final RunRecord record =
      new RunRecord(
          new RunPlan(Domain.GROUND, Optional.empty(), List.of(place("a", 0.0), place("b", 0.01))),
          samples::add);

  private static RunPlan.Waypoint place(String name, double latitudeDeg) {
    return new RunPlan.Waypoint(
        name, 0.0, latitudeDeg, OptionalDouble.empty(), 1.0, OptionalDouble.empty());
  }

  private double crossTrackM(GoalInformation goal) {
    record.received(new GoalList().goals(List.of(goal)).upcoming(List.of()));
    record.moment(samples.size(), EAST_DEG, 0.005, 0.0, 0.0, 1.0, "", Optional.empty());
    return samples.get(samples.size() - 1).crossTrackM();
  }

  @Test
  void moment_fromWaypointToWaypoint_isMeasuredFromTheirLine() {
    crossTrackM(new Waypoint().uid("a"));

    assertThat(crossTrackM(new Waypoint().uid("b"))).isCloseTo(10.0, within(0.1));
    assertThat(crossTrackM(new Waypoint().uid("b"))).isCloseTo(10.0, within(0.1));
  }

  @Test
  void moment_afterAGoalWithoutAPlace_hasNoLine() {
    crossTrackM(new Waypoint().uid("a"));

    assertThat(crossTrackM(new ObjectGoal().uid("barrel").objectType("barrel").within(2.0)))
        .isZero();
    assertThat(crossTrackM(new Waypoint().uid("b"))).isZero();
  }
}
