package org.u2sa.messages.schema;

import java.util.List;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.goal.PayloadDrop;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.TakeOff;

/** What the planners that see brought. */
final class GoldenPlans {
  private GoldenPlans() {}

  static void addTo(GoldenMessages golden) {
    golden.add(
        "PlannedPath",
        new PlannedPath()
            .subsystem("ARM")
            .goal("3")
            .planner("GRID")
            .status(PathStatus.WAITING)
            .reason("traffic on the way")
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .points(List.of(Point.of(0.0, 0.0, 0.0), Point.of(4.5, -2.0, 0.0)))
            .cost(6.25));
    golden.add(
        "ObjectGoal",
        new ObjectGoal()
            .uid("7")
            .objectType("buoy")
            .within(1.5)
            .speed(0.5)
            .pointed(List.of("GIMBAL")));
    golden.add(
        "NavigationPoint-backwards",
        NavigationPoint.at(Point.of(-1.5, 0.25, 0.0)).speed(0.5).backwards(true));
    golden.add("NavigationPoint-turn", NavigationPoint.at(Point.of(0.5, 0.25, 0.0)).turn(-0.75));
    golden.add(
        "Station",
        new Station()
            .duration(30.0)
            .approach(5.0)
            .backwards(true)
            .uid("8")
            .x(151.25)
            .y(-33.5)
            .psi(1.5)
            .horizontalThreshold(0.25));
    golden.add(
        "TakeOff", new TakeOff().uid("9").z(80.0).psi(1.5).verticalThreshold(5.0).horizontalThreshold(15.0));
    golden.add(
        "Landing",
        new Landing()
            .approach(400.0)
            .slope(0.0625)
            .uid("10")
            .x(151.25)
            .y(-33.5)
            .z(43.25)
            .psi(1.5)
            .speed(17.0)
            .horizontalThreshold(15.0));
    golden.add(
        "PayloadDrop",
        new PayloadDrop()
            .payload("BOTTLE")
            .height(30.0)
            .terminalSpeed(25.0)
            .uid("11")
            .x(151.25)
            .y(-33.5)
            .z(43.25)
            .horizontalThreshold(5.0));
  }
}
