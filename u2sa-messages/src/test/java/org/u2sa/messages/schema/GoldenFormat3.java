package org.u2sa.messages.schema;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.LandmarkSighting;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.GoalClass;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FenceAction;
import org.u2sa.messages.safety.FenceOrder;
import org.u2sa.messages.safety.FenceOrderResult;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.safety.ManualDrive;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.shape.Polygon;

/** What the third format brought: scans, and fields of older messages. */
final class GoldenFormat3 {
  private GoldenFormat3() {}

  static void addTo(GoldenMessages golden) {
    mission(golden);
    golden.add(
        "RangeScan",
        new RangeScan()
            .sensorName("Laser")
            .x(0.5)
            .y(-0.25)
            .z(-0.125)
            .phi(0.0625)
            .theta(-0.03125)
            .psi(1.5)
            .minRange(0.25)
            .maxRange(5.5)
            .timeIncrement(0.0009765625)
            .beams(
                -0.5,
                0.25,
                List.of(OptionalDouble.of(2.5), OptionalDouble.empty(), OptionalDouble.of(3.75))));
    golden.add(
        "RangeScan-uneven",
        new RangeScan()
            .sensorName("Laser")
            .referenceFrame(ReferenceFrame.BODY_FRD)
            .maxRange(12.0)
            .beams(
                List.of(
                    new RangeScan.Beam(0.0, OptionalDouble.empty()),
                    new RangeScan.Beam(-0.015625, OptionalDouble.of(2.5)))));
    golden.add("RangeScan-empty", new RangeScan().sensorName("Laser").maxRange(12.0));
    golden.add("InertialMeasurement", inertial());
    golden.add("LandmarkSighting", sighting());
    golden.add(
        "EmergencyStop-named",
        new EmergencyStop().active(true).operator("anna").reason("smoke").stopId("anna 1"));
    golden.add(
        "EmergencyStop-lifts",
        new EmergencyStop()
            .operator("anna")
            .clears(GoldenMessages.MICROS)
            .lifts(List.of("anna 1", "SafetyManager 2")));
    golden.add("HealthReport-stopped", stopped(new HealthReport()));
    golden.add("ConnectionLost-stopped", stopped(new ConnectionLost()));
    golden.add(
        "ServiceCondition-unwatched",
        new ServiceCondition().serviceName("Camera").condition(Condition.UNWATCHED));
    golden.add(
        "GoalList-landing",
        new GoalList().landGoals(4).fileFaults(List.of("landing.xml: there is no such file")));
    golden.add("ObjectList-awaited", new ObjectList().objects(List.of()).awaited(List.of("Laser")));
    golden.add(
        "HealthReport-commands",
        new HealthReport()
            .serviceName("Throttle")
            .status(ServiceStatus.RUNNING)
            .replaced(517)
            .commandsObeyed(1_000)
            .commandsRefused(3)
            .refusedSubscriptions("goal-commands,stop"));
  }

  private static LandmarkSighting sighting() {
    LandmarkSighting seen =
        new LandmarkSighting()
            .landmarkX(12.5)
            .landmarkY(-3.25)
            .range(4.75)
            .rangeSigma(0.125)
            .bearing(-0.5)
            .bearingSigma(0.0625);
    seen.sensorName("Landmarks").referenceFrame(ReferenceFrame.LOCAL_NED);
    return seen;
  }

  private static InertialMeasurement inertial() {
    InertialMeasurement measured =
        new InertialMeasurement()
            .rollRate(0.125)
            .pitchRate(-0.25)
            .yawRate(0.5)
            .angularRateSigma(0.0078125)
            .specificForceX(1.5)
            .specificForceY(-0.75)
            .specificForceZ(-9.8125)
            .specificForceSigma(0.0625);
    measured.sensorName("IMU");
    return measured;
  }

  private static HealthReport stopped(HealthReport report) {
    return report
        .serviceName("Simulator")
        .status(ServiceStatus.RUNNING)
        .emergencyStops(List.of("anna 1"));
  }

  private static void mission(GoldenMessages golden) {
    Waypoint branching = new Waypoint().uid("gate").x(10.0).y(54.0).horizontalThreshold(2.0);
    branching
        .nextIf(GoalResult.DONE, List.of("red buoy", "green buoy"))
        .nextIf(GoalResult.FAILED, List.of("dock"))
        .nextIf(GoalResult.TIMED_OUT, List.of())
        .choose(1)
        .timeLimit(90.5)
        .repeatFrom("gate")
        .repeatTimes(2);
    golden.add("Waypoint-branching", branching);
    Waypoint lost = new Waypoint().uid("hoop").x(10.0).y(54.0).horizontalThreshold(2.0);
    lost.abandoned(true)
        .result(GoalResult.TIMED_OUT)
        .reason("not done within 90.5 s")
        .arrivedAt(GoldenMessages.MICROS);
    golden.add("Waypoint-timed-out", lost);
    golden.add("MissionRequest", new MissionRequest().requestId("q1"));
    golden.add(
        "MissionReport",
        new MissionReport()
            .requestId("q1")
            .serviceName("MissionManager")
            .mission("missions/boat/gate.xml")
            .goals(List.of(branching.copy(), lost.copy()))
            .finished(List.of(0.0, 1.0))
            .current(List.of("gate"))
            .upcoming(List.of("red buoy", "green buoy"))
            .sequence(List.of("gate", "hoop"))
            .failsafe("RETURN")
            .elapsed(12.5)
            .timeLimit(1200.0)
            .began(GoldenMessages.MICROS)
            .resumable("gate"));
    golden.add(
        "MissionOrder",
        new MissionOrder()
            .requestId("o1")
            .action(MissionAction.INSERT)
            .uid("gate")
            .goals("<mission><waypoint><x>1</x></waypoint></mission>")
            .file("more.xml")
            .now(true)
            .operator("anna"));
    golden.add(
        "MissionOrderResult",
        new MissionOrderResult()
            .requestId("o1")
            .serviceName("MissionManager")
            .accepted(true)
            .outcome("goal \"2\" inserted after \"gate\""));
    golden.add(
        "FenceOrder",
        new FenceOrder()
            .requestId("o3")
            .action(FenceAction.REPLACE)
            .fence("<fence/>")
            .file("field.xml")
            .operator("anna"));
    golden.add(
        "FenceOrderResult",
        new FenceOrderResult()
            .requestId("o3")
            .serviceName("SafetyManager")
            .accepted(true)
            .outcome("fence of field.xml in force"));
    golden.add(
        "FenceState",
        new FenceState()
            .fence("<fence/>")
            .file("field.xml")
            .margin(2.5)
            .lowest(55.0)
            .highest(162.5)
            .keepIn(List.of(area("keep-in 1")))
            .keepOut(List.of(area("keep-out 1")))
            .rally(
                List.of(
                    new Waypoint()
                        .uid("rally 1")
                        .x(10.5)
                        .y(54.25)
                        .z(60.0)
                        .horizontalThreshold(1.0))));
    golden.add("ManualOrder", new ManualOrder().requestId("o4").active(true).operator("anna"));
    golden.add(
        "ManualState",
        new ManualState()
            .active(true)
            .operator("anna")
            .reason("disarmed")
            .requestId("o4")
            .takeovers(3));
    golden.add(
        "ManualDrive",
        new ManualDrive()
            .operator("anna")
            .speed(1.25)
            .turnRate(-0.5)
            .speedShare(0.75)
            .turnShare(-0.25));
    golden.add("GoalList-paused", new GoalList().paused(true));
    golden.add(
        "DiscoveryResponse-choices",
        new DiscoveryResponse()
            .serviceName("PathPlanner")
            .serviceType("PATH_PLANNER")
            .status(ServiceStatus.RUNNING)
            .className("org.u2sa.planning.PathPlanner")
            .choices(
                List.of("org.u2sa.planning.PathPlanner", "org.u2sa.planning.VectorFieldPlanner")));
    golden.add("MissionRequest-classes", new MissionRequest().requestId("q3").classes(true));
    golden.add(
        "GoalClass",
        new GoalClass()
            .serviceName("MissionManager")
            .className("SearchArea")
            .variables(
                List.of(
                    new ConfigurationVariable()
                        .name("resolution")
                        .variableType("double")
                        .unit("m")
                        .min(0.0625)
                        .max(1.25)))
            .required(List.of("resolution")));
    golden.add("GoalList-elapsed", new GoalList().elapsed(62.5));
    golden.add("GoalList-returning", new GoalList().returning(true));
    golden.add(
        "ActuatorAnnouncement-withheld",
        new ActuatorAnnouncement()
            .actuatorName("LEFT MOTOR")
            .minimum(-100.0)
            .maximum(100.0)
            .withheld(true));
    golden.add(
        "ActuatorAnnouncement-percentage",
        new ActuatorAnnouncement()
            .actuatorName("RELEASE")
            .minimum(0.0)
            .maximum(100.0)
            .percentage(100.0));
    golden.add(
        "MissionReport-paused",
        new MissionReport().requestId("q2").serviceName("MissionManager").paused(true));
    golden.add(
        "MissionReport-home",
        new MissionReport().requestId("q3").serviceName("MissionManager").homeAltitude(43.3));
    golden.add(
        "MissionOrder-pause",
        new MissionOrder().requestId("o2").action(MissionAction.PAUSE).operator("anna"));
  }

  private static Polygon area(String name) {
    Polygon area = new Polygon();
    area.uid(name).x(10.5).y(54.25);
    return area.points(
        List.of(
            Point.of(10.5, 54.25, 0.0), Point.of(10.75, 54.25, 0.0), Point.of(10.5, 54.5, 0.0)));
  }
}
