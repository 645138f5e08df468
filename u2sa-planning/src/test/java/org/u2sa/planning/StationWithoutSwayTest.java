package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Station;
import org.u2sa.testkit.ServiceKit;

/** A boat with two stern thrusters, which turns in place but has no sideways thrust. */
class StationWithoutSwayTest {
  private static final double STEP_S = 0.1;
  private static final double TURN_RATE = Math.toRadians(25.0);

  private final ServiceKit kit = new ServiceKit();
  private PathPlanner planner;
  private double north;
  private double east;
  private double heading;
  private double eastwardMps; // current
  private double farthestM; // from the station

  private void pursue(Station station) {
    planner = kit.start(PathPlanner::new);
    station
        .uid("S")
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(0.0)
        .y(0.0)
        .horizontalThreshold(1.0);
    station.duration(10.0);
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(station)));
    north = -6.0;
    east = 0.5;
  }

  /** Drives until the goal has ended; empty if it has not. */
  private Optional<GoalInformation> drive(double seconds) {
    for (int i = 0; i < seconds / STEP_S; i++) {
      step();
      List<GoalInformation> reports = kit.published(Channels.GOAL_REPORTS);
      if (!reports.isEmpty()) {
        return Optional.of(reports.get(0));
      }
    }
    return Optional.empty();
  }

  private void step() {
    kit.advance(STEP_S);
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(north)
            .y(east)
            .z(0.0)
            .xDot(0.0)
            .yDot(0.0)
            .psi(heading);
    state.timestamp(kit.clock().micros());
    kit.publish(Channels.STATE, state);
    kit.latest(Channels.NAVIGATION).ifPresent(this::obey);
    east += STEP_S * eastwardMps;
    farthestM = Math.max(farthestM, Math.hypot(north, east));
  }

  /** As AllocatingControl without SWAY: the heading of the turn, or else the way to the point. */
  private void obey(NavigationPoint point) {
    double ahead = point.point().x();
    double bearing = Math.atan2(-point.point().y(), ahead); // BODY: y is to the left
    double distance = Math.hypot(ahead, point.point().y());
    double turn = point.turn().orElse(distance < 1.0 ? 0.0 : bearing);
    heading += Math.max(-TURN_RATE * STEP_S, Math.min(TURN_RATE * STEP_S, turn));
    double limit = point.speed().orElse(1.0);
    double speed = Math.max(-limit, Math.min(limit, 0.4 * ahead));
    north += STEP_S * speed * Math.cos(heading);
    east += STEP_S * speed * Math.sin(heading);
  }

  @Test
  void plan_headingAcrossTheWay_isCompleted() {
    pursue((Station) new Station().psi(Math.PI / 2.0));

    assertThat(drive(60.0)).hasValueSatisfying(end -> assertThat(end.completed()).isTrue());
    assertThat(Math.hypot(north, east)).isLessThan(0.5);
  }

  @Test
  void plan_isKnownToDrift_doesNotTryTheHeadingFirst() {
    kit.with("DRIFTS", true);
    pursue((Station) new Station().psi(Math.PI / 2.0));

    assertThat(drive(30.0)).hasValueSatisfying(end -> assertThat(end.completed()).isTrue());
  }

  @Test
  void plan_carriedAwayWhileItKeepsTheHeading_facesTheStationAgain() {
    pursue((Station) new Station().psi(0.0));
    north = -3.0;
    east = 0.0;
    drive(5.0);
    east = 2.0;

    assertThat(drive(60.0)).hasValueSatisfying(end -> assertThat(end.completed()).isTrue());
  }

  @Test
  void plan_berth_isEnteredOnItsLine() {
    pursue((Station) new Station().approach(6.0).psi(Math.PI / 2.0));

    assertThat(drive(150.0)).hasValueSatisfying(end -> assertThat(end.completed()).isTrue());
    assertThat(Math.abs(north)).isLessThan(0.3);
  }

  @Test
  void plan_berthBackwards_isEnteredOnItsLine() {
    pursue((Station) new Station().approach(6.0).backwards(true).psi(Math.PI / 2.0));

    assertThat(drive(150.0)).hasValueSatisfying(end -> assertThat(end.completed()).isTrue());
    assertThat(Math.abs(north)).isLessThan(0.3);
  }

  @Test
  void plan_pushedOffTheLineOfABerth_backsOutNoFurtherThanItsStartAndEnters() {
    kit.with("DRIFTS", true);
    pursue((Station) new Station().approach(6.0).psi(0.0));
    north = -4.0;
    east = 0.0;
    drive(40.0);
    farthestM = 0.0;
    east = 0.8;

    assertThat(drive(150.0)).hasValueSatisfying(end -> assertThat(end.completed()).isTrue());
    assertThat(farthestM).isLessThan(8.5);
  }

  @Test
  void plan_currentAcrossABerth_isGivenUpWithTheReasonAndStaysNear() {
    eastwardMps = 0.3;
    pursue((Station) new Station().approach(6.0).psi(0.0));
    north = -10.0;

    assertThat(drive(400.0))
        .hasValueSatisfying(
            end -> {
              assertThat(end.abandoned()).isTrue();
              assertThat(end.reason().orElseThrow())
                  .contains("given up: not kept for its duration within 330 s")
                  .contains("off its heading");
            });
    assertThat(farthestM).isLessThan(12.0);
  }

  @Test
  void plan_giveUpTimeIsZero_isNeverGivenUp() {
    eastwardMps = 0.3;
    kit.with("STATION GIVE UP AFTER", 0.0);
    pursue((Station) new Station().psi(0.0));

    assertThat(drive(600.0)).isEmpty();
  }

  @Test
  void takeOver_itFacesTheWay_successorDoesAtOnce() {
    pursue((Station) new Station().psi(Math.PI / 2.0));
    drive(8.0); // turns to the heading in vain
    for (int i = 0; i < 100 && heading > Math.toRadians(60.0); i++) {
      step(); // until it faces the station again
    }
    kit.swap(planner, PathPlanner::new);
    drive(7.0);

    assertThat(Math.hypot(north, east)).isLessThan(1.0);
  }
}
