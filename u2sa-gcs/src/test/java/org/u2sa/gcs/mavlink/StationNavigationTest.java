package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.dronefleet.mavlink.common.NavControllerOutput;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalList;

/** What a station is told about the way to the goal: wanted minus actual values. */
class StationNavigationTest {
  private static final double EAST = Math.PI / 2.0;
  private static final Geodetic HOME = new Geodetic(BridgeKit.LONGITUDE, BridgeKit.LATITUDE, 3.0);

  private final BridgeKit kit = BridgeKit.rover().ready(); // the first goal is east of the home

  /** The vehicle is so far north and east of its home [m], and heads east. */
  private NavControllerOutput at(double northM, double eastM) {
    Geodetic here = HOME.fromEnu(Point.of(eastM, northM, 0.0));
    kit.says(
        new StateInformation()
            .x(here.longitudeDeg())
            .y(here.latitudeDeg())
            .z(3.0)
            .xDot(2.0)
            .yDot(0.0)
            .psi(EAST));
    kit.advance(1.0);
    List<NavControllerOutput> all = kit.received(NavControllerOutput.class);
    return all.get(all.size() - 1);
  }

  @Test
  void crossTrack_besideTheLeg_isPositiveIfTheLegIsToTheRight() {
    assertThat(at(0.0, 10.0).xtrackError()).isCloseTo(0.0f, within(0.05f));
    assertThat(at(4.0, 20.0).xtrackError()).isCloseTo(4.0f, within(0.05f));
    assertThat(at(-4.0, 30.0).xtrackError()).isCloseTo(-4.0f, within(0.05f));
  }

  @Test
  void crossTrack_atTheNextGoal_isThatOfTheLegFromTheWaypointBefore() {
    Geodetic first = HOME.fromEnu(Point.of(0.0, 0.0, 0.0));
    double legM = HOME.distanceM(new Geodetic(BridgeKit.LONGITUDE + 0.001, first.latitudeDeg(), 3));
    at(2.0, legM - 2.0);
    kit.says(new GoalList().goals(List.of(BridgeKit.waypoint("2", 0.001, 0.001))));

    assertThat(at(50.0, legM - 5.0).xtrackError()).isCloseTo(5.0f, within(0.1f));
  }

  @Test
  void crossTrack_whereThePlannerHasAPathAroundSomething_isThatOfThePath() {
    kit.says(
        new PlannedPath()
            .goal("1")
            .planner("A*")
            .status(PathStatus.FOLLOWED)
            .points(List.of(corner(0.0, 0.0), corner(20.0, 20.0), corner(20.0, 60.0))));

    assertThat(at(19.0, 40.0).xtrackError()).isCloseTo(-1.0f, within(0.05f));
    kit.says(
        new PlannedPath()
            .goal("1")
            .planner("A*")
            .status(PathStatus.WAITING)
            .points(List.of(corner(0.0, 0.0), corner(20.0, 20.0))));
    assertThat(at(19.0, 40.0).xtrackError()).isCloseTo(19.0f, within(0.05f));
  }

  private static Point corner(double northM, double eastM) {
    return HOME.fromEnu(Point.of(eastM, northM, 0.0)).point();
  }

  @Test
  void speedAndBearing_ofTheNavigationPoint_areTold() {
    kit.says(NavigationPoint.at(Point.of(3.0, -3.0, 0.0)).speed(2.5)); // ahead and to the right
    NavControllerOutput told = at(0.0, 10.0);

    assertThat(told.aspdError()).isCloseTo(0.5f, within(0.01f));
    assertThat(told.navBearing()).isEqualTo(135);
    assertThat(told.targetBearing()).isEqualTo(90);
    assertThat(told.altError()).isZero();
  }

  @Test
  void speed_notStatedOrOld_is0() {
    kit.says(NavigationPoint.at(Point.of(3.0, 0.0, 0.0)));
    assertThat(at(0.0, 10.0).aspdError()).isZero();
    kit.says(NavigationPoint.at(Point.of(3.0, 0.0, 0.0)).speed(2.5));
    kit.advance(2.0);
    assertThat(at(0.0, 10.0).aspdError()).isZero();
  }
}
