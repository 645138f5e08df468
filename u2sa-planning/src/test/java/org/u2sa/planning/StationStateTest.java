package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Station;
import org.u2sa.testkit.ServiceKit;

/** A station at the origin of a local plane, heading north. */
class StationStateTest {
  private final ServiceKit kit = new ServiceKit();
  private PathPlanner planner;

  @BeforeEach
  void start() {
    planner = kit.start(PathPlanner::new);
  }

  private void pursue(Station station) {
    station
        .uid("S")
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(0.0)
        .y(0.0)
        .horizontalThreshold(0.5);
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(station)));
  }

  private NavigationPoint at(double north, double east, double heading) {
    return at(north, east, 0.0, heading);
  }

  private NavigationPoint at(double north, double east, double down, double heading) {
    kit.advance(0.1);
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(north)
            .y(east)
            .z(down)
            .xDot(0.0)
            .yDot(0.0)
            .psi(heading);
    state.timestamp(kit.clock().micros());
    kit.publish(Channels.STATE, state);
    return kit.latest(Channels.NAVIGATION).orElseThrow();
  }

  private List<GoalInformation> reports() {
    return kit.published(Channels.GOAL_REPORTS);
  }

  @Test
  void plan_far_facesTheWayWithoutAHeading() {
    pursue((Station) new Station().psi(0.0));

    assertThat(at(-40.0, 0.0, 0.3).turn()).isEmpty();
  }

  @Test
  void plan_near_turnsToTheHeading() {
    pursue((Station) new Station().psi(0.0));
    NavigationPoint point = at(-2.0, 0.0, 0.3);

    assertThat(point.turn().orElseThrow()).isCloseTo(-0.3, within(1e-9));
    assertThat(Math.hypot(point.point().x(), point.point().y())).isCloseTo(2.0, within(1e-9));
  }

  @Test
  void plan_nearWithoutAHeading_leavesItToControl() {
    pursue(new Station());

    assertThat(at(-0.2, 0.0, 0.3).turn()).isEmpty();
  }

  @Test
  void plan_staysForTheDuration_isCompletedOnce() {
    pursue((Station) new Station().duration(2.0).psi(0.0));
    for (int i = 0; i < 15; i++) {
      at(0.1, 0.0, 0.0);
    }
    assertThat(reports()).isEmpty();
    for (int i = 0; i < 10; i++) {
      at(0.1, 0.0, 0.0);
    }

    assertThat(reports()).isNotEmpty();
    assertThat(reports().get(0).completed()).isTrue();
  }

  @Test
  void plan_leavesTheThresholdOrHeadingMeanwhile_startsTheTimeAnew() {
    pursue((Station) new Station().duration(2.0).psi(0.0));
    for (int i = 0; i < 60; i++) {
      at(i % 15 == 14 ? 0.8 : 0.1, 0.0, i % 15 == 7 ? 0.2 : 0.0);
    }

    assertThat(reports()).isEmpty();
  }

  @Test
  void plan_outsideTheVerticalThreshold_doesNotCountAsThere() {
    pursue((Station) new Station().duration(1.0).z(3.0).verticalThreshold(0.3));
    for (int i = 0; i < 30; i++) {
      at(0.1, 0.0, 2.6, 0.0);
    }
    assertThat(reports()).isEmpty();
    for (int i = 0; i < 12; i++) {
      at(0.1, 0.0, 2.8, 0.0);
    }

    assertThat(reports()).isNotEmpty();
  }

  @Test
  void plan_durationUnset_keepsItForEver() {
    pursue(new Station());
    for (int i = 0; i < 200; i++) {
      at(0.1, 0.0, 0.0);
    }

    assertThat(reports()).isEmpty();
  }

  @Test
  void plan_berth_goesToTheStartOfItsWayAndAlongItSlowly() {
    pursue((Station) new Station().approach(6.0).duration(1.0).psi(0.0));
    NavigationPoint first = at(-2.0, -3.0, 0.0);
    assertThat(first.point().x()).isCloseTo(-4.0, within(1e-9)); // back to 6 m south of it
    assertThat(first.point().y()).isCloseTo(-3.0, within(1e-9)); // BODY: y is to the left

    NavigationPoint along = at(-6.0, 0.0, 0.0);
    assertThat(along.point().x()).isCloseTo(1.0, within(1e-9));
    assertThat(along.speed().orElseThrow()).isEqualTo(0.3);

    NavigationPoint pushedOff = at(-3.0, 0.5, 0.0); // waits until it is back on the line
    assertThat(pushedOff.point().x()).isCloseTo(0.0, within(1e-9));
    assertThat(pushedOff.point().y()).isCloseTo(0.5, within(1e-9));
  }

  @Test
  void plan_berthBackwards_comesFromTheOtherSideSternAhead() {
    pursue((Station) new Station().approach(6.0).backwards(true).psi(0.0));
    assertThat(at(6.0, 0.0, 0.0).point().x()).isCloseTo(-1.0, within(1e-9));
    assertThat(at(5.0, 0.0, 0.0).backwards()).isTrue();
  }

  @Test
  void takeOver_onStation_theTimeGoesOn() {
    pursue((Station) new Station().duration(2.0).psi(0.0));
    for (int i = 0; i < 15; i++) {
      at(0.1, 0.0, 0.0);
    }
    kit.swap(planner, PathPlanner::new);
    for (int i = 0; i < 8; i++) {
      at(0.1, 0.0, 0.0);
    }

    assertThat(reports()).isNotEmpty();
  }

  @Test
  void turns_vehicleThatDoesNotCircle_isGivenUpWithTheReason() {
    pursue(new Station().turns(1.0).radius(15.0));
    kit.advance(0.1);
    kit.publish(
        Channels.STATE,
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).psi(0.0));

    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow()).contains("turns need a LOITER RADIUS");
  }
}
