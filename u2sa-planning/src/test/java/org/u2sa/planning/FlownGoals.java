package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.PayloadDrop;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.testkit.ServiceKit;

/** A kinematic vehicle on a local plane that goes to its navigation points. */
abstract class FlownGoals {
  static final double STEP_S = 0.05;

  final ServiceKit kit = new ServiceKit();
  Point ned = Point.ORIGIN;
  Point velocity = Point.ORIGIN;
  Point wind = Point.ORIGIN;
  double heading;
  double roll;
  boolean released;
  boolean isStuck; // the release mechanism
  int drops; // each after a second without a command
  double commandedS = -10.0;
  double tooHighM; // its altitude as known
  Optional<Sphere> tower = Optional.empty();
  double nearestM = Double.POSITIVE_INFINITY; // to the middle of the tower

  void pursue(Waypoint goal) {
    goal.uid("G").referenceFrame(ReferenceFrame.LOCAL_NED);
    goal.horizontalThreshold(goal instanceof PayloadDrop ? 5.0 : 1.0);
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(goal)));
  }

  void plane() {
    kit.with("TURN ACCELERATION", 6.0);
    kit.with("LOOK AHEAD", 50.0);
    kit.with("LOITER RADIUS", 100.0);
    kit.start(PathPlanner::new);
  }

  /** A route planner, and something that reaches from the ground to the sky. */
  void tower(String planner, double north, double radiusM) {
    kit.with("PLANNER", planner).with("CLEARANCE", 2.0).with("PLANNING SPAN", 400.0);
    kit.with("VEHICLE WIDTH", 2.0).with("PLANNING CELL", 1.0).with("VERTICAL CLEARANCE", 500.0);
    Sphere body = new Sphere().radius(radiusM);
    body.uid("tower").objectType("tower").referenceFrame(ReferenceFrame.LOCAL_NED);
    body.x(north).y(1.0).z(0.0);
    tower = Optional.of(body);
  }

  /** One state and the answer to it, north, east, down of the vehicle. */
  Point step(double speedMps) {
    kit.advance(STEP_S);
    Point through = new Attitude(0.0, 0.0, heading).bodyOf(velocity.minus(wind));
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(ned.x())
            .y(ned.y())
            .z(ned.z() - tooHighM)
            .zSigma(0.5 * tooHighM)
            .xDot(velocity.x())
            .yDot(velocity.y())
            .zDot(velocity.z())
            .phi(roll)
            .theta(0.0)
            .psi(heading)
            .fluidxDot(through.x())
            .fluidyDot(through.y())
            .fluidzDot(through.z());
    state.timestamp(kit.clock().micros());
    tower.ifPresent(this::passBy);
    ActuatorAnnouncement release = new ActuatorAnnouncement().minimum(0.0).maximum(100.0);
    kit.publish(
        Channels.ACTUATORS,
        release.actuatorName("BOTTLE").percentage(drops > 0 && isCommanded() ? 100.0 : 0.0));
    kit.publish(Channels.STATE, state);
    Point to = Point.ORIGIN;
    for (NavigationPoint point : kit.<NavigationPoint>published(Channels.NAVIGATION)) {
      if (point.timestamp().orElse(0L) != kit.clock().micros()) {
        continue;
      }
      if (point.subsystem().equals("VEHICLE")) {
        to = new Attitude(0.0, 0.0, heading).nedOf(point.point());
      } else {
        released |= point.subsystem().equals("BOTTLE");
        drops += isStuck || isCommanded() ? 0 : 1;
        commandedS = kit.nowS();
      }
    }
    double level = Math.hypot(to.x(), to.y());
    double sink = Math.max(-4.0, Math.min(4.0, to.z()));
    double mps = Math.min(speedMps, level / STEP_S);
    velocity =
        level < 1e-6
            ? Point.of(0.0, 0.0, sink)
            : Point.of(mps * to.x() / level, mps * to.y() / level, sink);
    if (mps > 1.0) {
      heading = Math.atan2(velocity.y(), velocity.x());
    }
    ned = ned.plus(velocity.times(STEP_S));
    return to;
  }

  boolean isCommanded() {
    return kit.nowS() - commandedS < 1.0;
  }

  void passBy(Sphere obstacle) {
    nearestM = Math.min(nearestM, Math.hypot(ned.x() - obstacle.x(), ned.y() - obstacle.y()));
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(obstacle)));
  }

  List<GoalInformation> reports() {
    return kit.published(Channels.GOAL_REPORTS);
  }
}
