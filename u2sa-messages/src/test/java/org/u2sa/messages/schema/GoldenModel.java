package org.u2sa.messages.schema;

import java.util.List;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.messages.shape.Sphere;

/** Messages of the data model. */
final class GoldenModel {
  private GoldenModel() {}

  static void addTo(GoldenMessages golden) {
    golden.add("StateInformation", gps());
    StateInformation all = new StateInformation().sensorName("StateEstimator");
    for (StateField field : StateField.values()) {
      all.number(field, 0.125 * (field.ordinal() + 1));
    }
    golden.add("StateInformation-all", all.referenceFrame(ReferenceFrame.LOCAL_NED));
    golden.addAsItIs("StateInformation-none", new StateInformation());
    golden.add("Waypoint", waypoint());
    Waypoint last = bareWaypoint().uid("3").completed(true);
    last.referenceFrame(ReferenceFrame.LOCAL_NED).abandoned(true);
    golden.add("Waypoint-done", last);
    List<Waypoint> current = List.of(waypoint(), bareWaypoint());
    golden.add("GoalList", new GoalList().goals(current).upcoming(List.of(last)));
    golden.add(
        "ObjectDescription", object(new ObjectDescription()).level(ObjectLevel.AVOID_ALWAYS));
    golden.add("PointCloud", cloud());
    golden.add("Circle", object(new Circle().radius(2.5)));
    golden.add("Rectangle", object(new Rectangle().length(8.0).width(3.0).psi(0.5)));
    golden.add("Box", object(new Box().length(8.0).width(3.0).height(2.0).psi(0.5)));
    golden.add("Sphere", object(new Sphere().radius(1.5)));
    golden.add("Cylinder", object(new Cylinder().radius(1.5).height(20.0)).z(-3.0));
    golden.add("Line", object(new Line().points(List.of(Point.of(4, 8, 0), Point.of(5, 9, 0)))));
    golden.add(
        "ObjectList", new ObjectList().objects(List.of(cloud(), object(new Circle().radius(1)))));
    golden.add("NavigationPoint", NavigationPoint.at(Point.of(250.0, -12.5, 3.0)).speed(52.0));
    NavigationPoint arm = NavigationPoint.at(Point.of(0.5, 0.0, -0.25)).subsystem("ARM");
    golden.add("NavigationPoint-arm", arm.referenceFrame(ReferenceFrame.BODY_FLU));
    golden.add("ActuatorCommand", new ActuatorCommand().actuatorName("GRIPPER").expiry(0.5));
    golden.add("PercentageCommand", PercentageCommand.of("AILERON", -12.5).expiry(0.5));
  }

  private static StateInformation gps() {
    return new StateInformation()
        .sensorName("GPS")
        .x(-157.92)
        .y(21.32)
        .z(300.0)
        .xDot(40.0)
        .yDot(-30.5)
        .xSigma(2.5)
        .ySigma(2.5)
        .psi(2.25)
        .fluidxDot(52.0);
  }

  private static Waypoint waypoint() {
    Waypoint full = bareWaypoint().uid("1").next(List.of("2", "Return home"));
    full.description("Diamond Head é").z(300.0).phi(0.0).theta(0.0).psi(1.5).time(60.0);
    return full.verticalThreshold(15.0).speed(52.0);
  }

  private static Waypoint bareWaypoint() {
    return new Waypoint().uid("2").x(-157.8).y(21.25).horizontalThreshold(100.0);
  }

  private static ObjectDescription object(ObjectDescription object) {
    return object
        .uid("Circle1")
        .objectType("barrel")
        .referenceFrame(ReferenceFrame.LOCAL_ENU)
        .x(4.0)
        .y(8.0);
  }

  private static PointCloud cloud() {
    List<Point> points = List.of(Point.of(3.5, 8.0, 0.25), Point.of(4.5, 8.0, 0.5));
    return (PointCloud)
        object(new PointCloud().points(points)).referenceFrame(ReferenceFrame.utm(4, true));
  }
}
