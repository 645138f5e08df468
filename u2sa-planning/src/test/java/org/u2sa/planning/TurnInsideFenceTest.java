package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.Polygon;

/** A car drives north along a fence on its right, or towards one ahead, and returns. */
class TurnInsideFenceTest extends PlannedVehicle {
  private static final double RADIUS_M = 1.5;
  private static final double STEP_S = 0.1;
  private static final double ACCELERATION_MPS2 = 1.0;
  private static final double FAR_M = 100.0;

  private double north;
  private double east;
  private double heading;
  private double mps = 0.8;
  private double mostEastM;
  private double mostNorthM;

  /** Sets the limits of a fence: north and east of the start, without margin [m]. */
  private void begin(double northLimitM, double eastLimitM, boolean reverses) {
    kit.with("TURN RADIUS", RADIUS_M).with("REVERSES", reverses).with("REVERSE SPEED", 0.4);
    kit.with("LOOK AHEAD", 0.8).with("PLANNED SPEED", 0.8);
    kit.start(PathPlanner::new);
    Polygon area =
        new Polygon()
            .points(
                List.of(
                    Point.of(-FAR_M, -FAR_M, 0.0),
                    Point.of(northLimitM, -FAR_M, 0.0),
                    Point.of(northLimitM, eastLimitM, 0.0),
                    Point.of(-FAR_M, eastLimitM, 0.0)));
    area.uid("area").x(0.0).y(0.0).z(0.0).referenceFrame(ReferenceFrame.LOCAL_NED);
    kit.publish(Channels.FENCE, new FenceState().margin(0.6).keepIn(List.of(area)));
  }

  private void leadHome(double homeEastM, boolean returning) {
    GoalList home = new GoalList().goals(List.of(waypoint("home", -20.0, homeEastM)));
    kit.publish(Channels.GOALS, home.upcoming(List.of()).returning(returning));
  }

  private void drive(double seconds) {
    for (int i = 0; i * STEP_S < seconds; i++) {
      StateInformation state = state(north, east, heading);
      state.xDot(mps * Math.cos(heading)).yDot(mps * Math.sin(heading));
      kit.advance(STEP_S);
      kit.publish(Channels.STATE, state);
      move(kit.latest(Channels.NAVIGATION).orElseThrow());
    }
  }

  /** Pure pursuit as tight as the turn radius; it brakes before it changes its direction. */
  private void move(NavigationPoint to) {
    double ahead = to.backwards() ? -to.point().x() : to.point().x();
    double right = -to.point().y();
    double square = ahead * ahead + right * right;
    double curvature = ahead <= 0.0 ? Math.copySign(FAR_M, right) : 2.0 * right / square;
    curvature = Math.max(-1.0 / RADIUS_M, Math.min(1.0 / RADIUS_M, curvature));
    double wanted = to.speed().orElse(0.8) * (to.backwards() ? -1.0 : 1.0);
    double step = ACCELERATION_MPS2 * STEP_S;
    mps += Math.max(-step, Math.min(step, wanted - mps));
    north += mps * Math.cos(heading) * STEP_S;
    east += mps * Math.sin(heading) * STEP_S;
    heading += mps * curvature * STEP_S;
    mostEastM = Math.max(mostEastM, east);
    mostNorthM = Math.max(mostNorthM, north);
  }

  @ParameterizedTest
  @CsvSource({"0.2, 8.0", "0.5, 8.0", "-0.2, 8.0", "-0.2, -8.0"})
  void return_fenceBeside_turnsOnTheSideWithRoom(double headingRad, double homeEastM) {
    heading = headingRad;
    begin(FAR_M, 1.2, true);
    leadHome(homeEastM > 0.0 ? 0.8 : homeEastM, true);
    drive(40.0);

    assertThat(mostEastM).isLessThan(1.2);
    assertThat(north).as("on its way home").isLessThan(-10.0);
  }

  @Test
  void return_fenceAhead_backsOutFirst() {
    begin(1.0, FAR_M, true);
    leadHome(3.0, true);
    drive(60.0);

    assertThat(mostNorthM).isLessThan(1.0);
    assertThat(north).isLessThan(-10.0);
    assertThat(logged("no room to turn inside the fence: backing out")).isEqualTo(1);
  }

  @Test
  void return_fenceAheadOfOneThatCannotReverse_stops() {
    begin(1.0, FAR_M, false);
    leadHome(3.0, true);
    drive(20.0);

    assertThat(mostNorthM).isLessThan(1.0);
    assertThat(mps).isZero();
    assertThat(logged("no room to turn inside the fence: stopping")).isEqualTo(1);
  }

  @Test
  void goal_ofTheMission_isLeftToTheSafetyManager() {
    begin(FAR_M, 1.0, true);
    leadHome(8.0, false);
    drive(0.2);

    assertThat(point().y()).as("to the right").isNegative();
    assertThat(logged("inside the fence")).isZero();
  }
}
