package org.u2sa.planning;

import java.util.List;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Sphere;

/** A multirotor that goes up and down to its navigation points, in place. */
abstract class VerticalFlight extends PlannedVehicle {
  static final double STEP_S = 0.1;
  static final double CLEARANCE_M = 5.0;

  double clearanceM = CLEARANCE_M;
  double upM;
  double highestM;
  double lowestM = Double.POSITIVE_INFINITY;
  double sigmaM; // of the altitude
  double tiltSigmaRad;
  private double beforeM;

  void start(double fromM) {
    kit.with("PLANNER", "GRID").with("VERTICAL CLEARANCE", clearanceM);
    kit.with("EVASION CLIMB", 2.0).with("TRAFFIC CLEARANCE", 5.0).with("TRAFFIC HORIZON", 20.0);
    kit.with("PLANNING CELL", 1.0).with("PLANNING SPAN", 100.0).with("GIVE UP AFTER", 20.0);
    kit.start(PathPlanner::new);
    upM = fromM;
    beforeM = fromM;
  }

  /** Publishes objects and a state, and follows the answer vertically until above the ground. */
  void step(double groundM, ObjectDescription... objects) {
    kit.advance(STEP_S);
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(objects)));
    double climbMps = (upM - beforeM) / STEP_S;
    beforeM = upM;
    kit.publish(
        Channels.STATE,
        state(0.1 * Math.sin(5.0 * kit.nowS()), 0, 0)
            .z(-upM)
            .zSigma(sigmaM)
            .xDot(0.0)
            .yDot(0.0)
            .zDot(-climbMps)
            .phi(0.0)
            .phiSigma(tiltSigmaRad)
            .theta(0.0));
    double down =
        kit.latest(Channels.NAVIGATION)
            .filter(point -> point.timestamp().orElse(0L) == kit.clock().micros())
            .map(point -> new Attitude(0.0, 0.0, 0.0).nedOf(point.point()).z())
            .orElse(0.0);
    upM = Math.max(groundM, upM - STEP_S * Math.max(-3.0, Math.min(3.0, down)));
    highestM = Math.max(highestM, upM);
    lowestM = Math.min(lowestM, upM);
  }

  void begin(Waypoint goal) {
    goals(goal.horizontalThreshold(2.0).uid("1").referenceFrame(ReferenceFrame.LOCAL_NED));
  }

  GoalInformation pursue(Waypoint goal, double limitS, ObjectDescription... objects) {
    begin(goal);
    while (kit.nowS() < limitS && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      step(0.0, objects);
    }
    return kit.latest(Channels.GOAL_REPORTS).orElseThrow();
  }

  /** A slab above and below the vehicle, 20 m wide. */
  static Cylinder slab(double bottomM, double topM) {
    Cylinder slab = new Cylinder().radius(10.0).height(topM - bottomM);
    slab.uid("bridge").objectType("bridge").referenceFrame(ReferenceFrame.LOCAL_NED);
    slab.x(0.0).y(0.0).z(-0.5 * (bottomM + topM));
    return slab;
  }

  /** Something that crosses the place at a time, seen as a sphere. */
  Sphere crossing(double atS, double mps, double highM, double radiusM) {
    Sphere traffic = new Sphere().radius(radiusM);
    traffic.uid("traffic").objectType("traffic").referenceFrame(ReferenceFrame.LOCAL_NED);
    traffic.x(0.0).y(mps * (kit.nowS() - atS)).z(-highM);
    traffic.motion().velocity(Point.of(0.0, mps, 0.0));
    return traffic;
  }
}
