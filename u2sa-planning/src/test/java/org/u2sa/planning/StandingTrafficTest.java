package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.shape.MovingSphere;

/** A multirotor beside traffic that hovers at its altitude. */
class StandingTrafficTest extends PlannedVehicle {
  private static final double STEP_S = 0.1;
  private static final double UP_M = 25.0;
  private static final double SEPARATION_M = 20.0;

  private Point at = Point.of(0.0, 0.0, -UP_M);
  private Point velocity = Point.ORIGIN;
  private double nearestM = Double.POSITIVE_INFINITY;
  private double trafficUpM = UP_M;
  private double trafficDownMps; // as measured

  @BeforeEach
  void start() {
    kit.with("PLANNER", "GRID").with("VERTICAL CLEARANCE", 5.0).with("EVASION CLIMB", 2.0);
    kit.with("TRAFFIC CLEARANCE", 5.0).with("TRAFFIC HORIZON", 20.0).with("CLEARANCE", 3.0);
    kit.with("INFLATION", 6.0).with("PLANNING CELL", 1.0).with("PLANNING SPAN", 200.0);
    kit.with("LOOK AHEAD", 8.0).with("PLANNED SPEED", 8.0).with("REACTION TIME", 1.0);
    kit.with("PLANNED ACCELERATION", 2.0).with("PLANNED BRAKING", 2.0);
    kit.with("GIVE UP AFTER", 30.0).with("STUCK AFTER", 30.0);
    kit.start(PathPlanner::new);
  }

  /** Flies to the goal; the traffic is at a position, and moves at a velocity eastwards. */
  private void step(double trafficNorthM, double trafficEastM, double eastMps) {
    kit.advance(STEP_S);
    MovingSphere other = new MovingSphere().radius(SEPARATION_M);
    other.uid("drone").objectType("drone").referenceFrame(ReferenceFrame.LOCAL_NED);
    other.x(trafficNorthM).y(trafficEastM).z(-trafficUpM);
    other.motion().velocity(Point.of(0.0, eastMps, trafficDownMps));
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(other)));
    kit.publish(
        Channels.STATE,
        state(at.x(), at.y(), 0.0)
            .z(at.z())
            .xDot(velocity.x())
            .yDot(velocity.y())
            .zDot(velocity.z())
            .phi(0.0)
            .theta(0.0));
    velocity =
        kit.latest(Channels.NAVIGATION)
            .filter(point -> point.timestamp().orElse(0L) == kit.clock().micros())
            .map(
                point -> {
                  Point ned = new Attitude(0.0, 0.0, 0.0).nedOf(point.point());
                  double awayM = Math.max(1.0, Math.sqrt(ned.dot(ned)));
                  return ned.times(Math.min(3.0, point.speed().orElse(3.0)) / awayM);
                })
            .orElse(Point.ORIGIN);
    at = at.plus(velocity.times(STEP_S));
    Point apart = at.minus(Point.of(trafficNorthM, trafficEastM, -trafficUpM));
    nearestM = Math.min(nearestM, Math.sqrt(apart.dot(apart)));
  }

  private GoalInformation report() {
    return kit.latest(Channels.GOAL_REPORTS).orElseThrow();
  }

  @ParameterizedTest
  @CsvSource({"-60, 15", "60, 15", "60, 6"})
  void waypoint_beginsWithinASeparation_isReachedWithoutComingCloser(
      double goalNorthM, double trafficNorthM) {
    goals(waypoint("1", goalNorthM, 0.0).z(-UP_M));
    while (kit.nowS() < 120.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      step(trafficNorthM, 0.0, 0.0);
    }
    assertThat(report().completed()).isTrue();
    assertThat(nearestM).isGreaterThan(trafficNorthM - 1.0);
  }

  @Test
  void waypoint_trafficStopsOnTheLeg_isPassedAtADistance() {
    goals(waypoint("1", 120.0, 0.0).z(-UP_M));
    while (kit.nowS() < 200.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      double eastM = Math.min(0.0, -60.0 + 5.0 * kit.nowS());
      step(60.0, eastM, eastM < 0.0 ? 5.0 : 0.0);
    }
    assertThat(report().completed()).isTrue();
    assertThat(nearestM).isGreaterThan(SEPARATION_M);
  }

  /** It descends through the vehicle's altitude, stops, and seems to descend for 8 s longer. */
  @ParameterizedTest
  @CsvSource({"10, 4", "12, -6", "14, 0"})
  void waypoint_trafficStopsDescendingBelow_isNotFlownOver(double belowM, double trafficEastM) {
    goals(waypoint("1", 60.0, 0.0).z(-UP_M));
    while (kit.nowS() < 90.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      double wayM = 1.7 * kit.nowS();
      trafficUpM = Math.max(UP_M - belowM, UP_M + 15.0 - wayM);
      double sinceS = kit.nowS() - (15.0 + belowM) / 1.7;
      trafficDownMps = sinceS < 0.0 ? 1.7 : sinceS < 8.0 ? 1.7 - 0.1 * sinceS : 0.0;
      step(64.0, trafficEastM, 0.0);
    }
    assertThat(nearestM).isGreaterThan(SEPARATION_M);
  }
}
