package org.u2sa.messages.schema;

import java.util.List;
import org.u2sa.messages.GroundPressure;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.goal.PayloadDrop;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.CoverageLedger;
import org.u2sa.messages.shape.ImageFootprint;

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
        "Station-circle",
        new Station()
            .duration(30.0)
            .radius(-120.0)
            .turns(2.5)
            .towardsNext(true)
            .uid("9")
            .z(150.0)
            .horizontalThreshold(15.0));
    golden.add(
        "Waypoint-camera",
        new Waypoint()
            .uid("10")
            .x(151.25)
            .y(-33.5)
            .z(80.0)
            .horizontalThreshold(15.0)
            .photoDistance(25.0)
            .lookAt(Point.of(151.125, -33.5, 12.5))
            .landingStart(true));
    golden.add(
        "TakeOff",
        new TakeOff().uid("9").z(80.0).psi(1.5).verticalThreshold(5.0).horizontalThreshold(15.0));
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
    golden.add(
        "GroundPressure", new GroundPressure().operator("anna").pressure(100_325.0).z(43.25));
    addSearch(golden);
  }

  private static void addSearch(GoldenMessages golden) {
    List<Point> corners =
        List.of(
            Point.of(151.25, -33.5, 0.0),
            Point.of(151.5, -33.5, 0.0),
            Point.of(151.5, -33.25, 0.0));
    golden.add(
        "SearchArea",
        new SearchArea()
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .corners(corners)
            .resolution(0.05)
            .ground(43.25)
            .lowest(80.0)
            .highest(120.0)
            .speed(22.0)
            .share(0.99)
            .seen(0.5)
            .uid("12"));
    golden.add(
        "ImageFootprint",
        GoldenWorld.seen(
            new ImageFootprint().image(7).resolution(0.0625).angle(0.5).points(corners)));
    golden.add(
        "CoverageLedger",
        GoldenWorld.seen(
            new CoverageLedger()
                .points(corners)
                .area("12")
                .cells(
                    Point.of(151.25, -33.5, 0.0),
                    5.0,
                    2,
                    new byte[] {10, 0, 12, 0},
                    new byte[] {3, 0, 30, (byte) CoverageLedger.OUTSIDE},
                    new byte[] {0, 7, 0, 0, 1, 2, 0, 0})));
  }
}
