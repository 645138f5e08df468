package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.MovingSphere;

/** A multirotor that climbs, as its goal or away from traffic, below the ceiling of the fence. */
class ClimbBelowCeilingTest extends PlannedVehicle {
  private static final double STEP_S = 0.1;
  private static final double UP_M = 25.0;
  private static final double CEILING_M = 52.0;
  private static final double CLIMB_MPS = 3.0; // faster than EVASION CLIMB

  private Point at = Point.of(0.0, 0.0, -UP_M);
  private Point velocity = Point.ORIGIN;
  private double apartM; // of the traffic, beside
  private double highestM;
  private double leastM = Double.POSITIVE_INFINITY; // room to level off, as the Safety Manager sees

  private void step() {
    kit.advance(STEP_S);
    MovingSphere other = new MovingSphere().radius(20.0);
    other.uid("drone").objectType("drone").referenceFrame(ReferenceFrame.LOCAL_NED);
    other.x(-120.0 + 12.0 * kit.nowS()).y(apartM).z(-UP_M + 4.0);
    other.motion().velocity(Point.of(12.0, 0.0, 0.0));
    kit.publish(Channels.FENCE, new FenceState().highest(CEILING_M));
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
    Point way =
        kit.latest(Channels.NAVIGATION)
            .map(point -> new Attitude(0.0, 0.0, 0.0).nedOf(point.point()))
            .orElse(Point.ORIGIN);
    double aside = Math.max(1.0, Math.hypot(way.x(), way.y()));
    double wantedMps = Math.max(-CLIMB_MPS, Math.min(CLIMB_MPS, 2.0 * way.z()));
    double downMps =
        velocity.z() + Math.max(-STEP_S, Math.min(STEP_S, wantedMps - velocity.z())); // 1 m/s²
    velocity = Point.of(5.0 * way.x() / aside, 5.0 * way.y() / aside, downMps);
    at = at.plus(velocity.times(STEP_S));
    double climbMps = Math.max(0.0, -downMps);
    double overshootM = climbMps + climbMps * climbMps / (2.0 * 0.8);
    highestM = Math.max(highestM, -at.z());
    leastM = Math.min(leastM, CEILING_M + at.z() - overshootM);
  }

  private void start() {
    kit.with("PLANNER", "GRID").with("VERTICAL CLEARANCE", 5.0).with("EVASION CLIMB", 2.0);
    kit.with("TRAFFIC CLEARANCE", 5.0).with("TRAFFIC HORIZON", 20.0).with("CLEARANCE", 3.0);
    kit.with("INFLATION", 6.0).with("PLANNING CELL", 1.0).with("PLANNING SPAN", 200.0);
    kit.with("LOOK AHEAD", 8.0).with("PLANNED SPEED", 8.0).with("REACTION TIME", 1.0);
    kit.with("PLANNED ACCELERATION", 2.0).with("PLANNED BRAKING", 2.0);
    kit.start(PathPlanner::new);
  }

  @Test
  void waypoint_trafficOvertakes_climbsNoFasterThanItCanLevelOff() {
    start();
    goals(waypoint("1", 150.0, 0.0).z(-UP_M));
    while (kit.nowS() < 40.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      step();
    }
    assertThat(highestM).isGreaterThan(UP_M + 15.0);
    assertThat(leastM).isNotNegative();
  }

  @Test
  void takeOff_belowTheCeiling_climbsNoFasterThanItCanLevelOff() {
    apartM = 500.0;
    at = Point.ORIGIN;
    start();
    TakeOff up = new TakeOff();
    up.x(0.0).y(0.0).z(-CEILING_M + 4.0).horizontalThreshold(2.0);
    goals(up.uid("up").referenceFrame(ReferenceFrame.LOCAL_NED));
    while (kit.nowS() < 60.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      step();
    }
    assertThat(highestM).isGreaterThan(CEILING_M - 5.0);
    assertThat(leastM).isNotNegative();
    assertThat(kit.latest(Channels.GOAL_REPORTS)).isPresent();
  }
}
