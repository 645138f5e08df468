package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.planning.guidance.Leg;

/** A multirotor on its way to a waypoint, and traffic from which it cannot keep its separation. */
class OncomingTrafficTest extends PlannedVehicle {
  private static final double STEP_S = 0.2;
  private static final double TURN_RAD = Math.toRadians(9.0); // in a step
  private static final double CHANGE_MPS = 0.4; // of the velocity, in a step
  private static final double UP_M = 20.0;

  private Point at = Point.of(0.0, 0.0, -UP_M);
  private Point velocity = Point.ORIGIN;
  private double headingRad;

  private void start(double climbMps) {
    kit.with("PLANNER", "GRID").with("VERTICAL CLEARANCE", 5.0).with("EVASION CLIMB", climbMps);
    kit.with("TRAFFIC CLEARANCE", 5.0).with("TRAFFIC HORIZON", 20.0).with("CLEARANCE", 3.0);
    kit.with("INFLATION", 6.0).with("PLANNING CELL", 1.0).with("PLANNING SPAN", 400.0);
    kit.with("LOOK AHEAD", 8.0).with("PLANNED SPEED", 8.0).with("REACTION TIME", 1.0);
    kit.with("PLANNED ACCELERATION", 2.0).with("PLANNED BRAKING", 2.0).with("AT END", "HOLD");
    kit.start(PathPlanner::new);
  }

  private void step(MovingSphere drone) {
    kit.advance(STEP_S);
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(drone)));
    kit.publish(
        Channels.STATE,
        state(at.x(), at.y(), headingRad)
            .z(at.z())
            .xDot(velocity.x())
            .yDot(velocity.y())
            .zDot(velocity.z())
            .phi(0.0)
            .theta(0.0));
    Optional<NavigationPoint> newest =
        kit.latest(Channels.NAVIGATION)
            .filter(point -> point.timestamp().orElse(0L) == kit.clock().micros());
    Point wanted = newest.map(this::wanted).orElse(Point.ORIGIN);
    Point change = wanted.minus(velocity);
    double share = Math.min(1.0, CHANGE_MPS / Math.max(1.0e-9, change.distance()));
    velocity = velocity.plus(change.times(share));
    at = at.plus(velocity.times(STEP_S));
  }

  private Point wanted(NavigationPoint point) {
    Point ned = new Attitude(0.0, 0.0, headingRad).nedOf(point.point());
    double awayM = Math.hypot(ned.x(), ned.y());
    double turnRad = awayM < 1.0 ? 0.0 : Leg.wrapped(Math.atan2(ned.y(), ned.x()) - headingRad);
    headingRad += Math.max(-TURN_RAD, Math.min(TURN_RAD, turnRad));
    double mps = Math.min(point.speed().orElse(3.0), awayM) / Math.max(0.01, awayM);
    return Point.of(mps * ned.x(), mps * ned.y(), Math.max(-2.0, Math.min(2.0, ned.z())));
  }

  private static MovingSphere drone(Point from, Point mps, double seconds, double separationM) {
    Point now = from.plus(mps.times(seconds));
    MovingSphere drone = new MovingSphere().radius(separationM);
    drone.uid("drone").objectType("drone").referenceFrame(ReferenceFrame.LOCAL_NED);
    drone.x(now.x()).y(now.y()).z(now.z());
    drone.motion().velocity(mps);
    return drone;
  }

  /** Where it stopped before, it would have been passed within a few metres. */
  @ParameterizedTest
  @CsvSource({
    "400, 0, -12, 150, 2",
    "300, 0, -12, 100, 0",
    "260, 150, -13, 100, 2",
    "0, 150, 0, 120, 2",
    "200, 3, -18, 80, 2",
    "300, 0, -12, 1000, 2"
  })
  void waypoint_trafficComesOn_staysAsFarAwayAsItCan(
      double north, double east, double northMps, double separationM, double climbMps) {
    start(climbMps);
    goals(waypoint("1", 150.0, 0.0).z(-UP_M).horizontalThreshold(2.0));
    Point from = Point.of(north, east, -UP_M);
    Point mps = Point.of(northMps, -7.5 * Math.signum(east) * Math.min(1.0, east / 100.0), 0.0);
    double nearestM = Double.POSITIVE_INFINITY;
    while (kit.nowS() < 50.0) {
      MovingSphere drone = drone(from, mps, kit.nowS(), separationM);
      step(drone);
      nearestM = Math.min(nearestM, at.minus(drone.center()).distance());
    }

    assertThat(nearestM).isGreaterThan(30.0);
  }
}
