package org.u2sa.messages;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ArmCommand;
import org.u2sa.messages.contract.ArmingState;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationChangeResult;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.EmergencyStop;
import org.u2sa.messages.contract.FailsafeAction;
import org.u2sa.messages.contract.FailsafeState;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.GoalCommand;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.OperatorHeartbeat;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.contract.StopCommand;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * One message or more of every type, whose bytes lie in docs/wire/golden. Never change one: add.
 */
final class GoldenMessages {
  private static final long MICROS = 1_700_000_000_123_456L;

  private final Map<String, U2SAData> byName = new LinkedHashMap<>();

  private GoldenMessages() {}

  static Map<String, U2SAData> all() {
    GoldenMessages golden = new GoldenMessages();
    golden.addModel();
    golden.addContract();
    golden.addFormat2();
    return golden.byName;
  }

  private void add(String name, U2SAData message) {
    message.systemId("cessna");
    message.timestamp(MICROS);
    byName.put(name, message);
  }

  private void addModel() {
    add("StateInformation", gps());
    StateInformation all = new StateInformation().sensorName("StateEstimator");
    for (StateField field : StateField.values()) {
      all.number(field, 0.125 * (field.ordinal() + 1));
    }
    add("StateInformation-all", all.referenceFrame(ReferenceFrame.LOCAL_NED));
    byName.put("StateInformation-none", new StateInformation());
    add("Waypoint", waypoint());
    Waypoint last = bareWaypoint().uid("3").completed(true);
    last.referenceFrame(ReferenceFrame.LOCAL_NED).abandoned(true);
    add("Waypoint-done", last);
    List<Waypoint> current = List.of(waypoint(), bareWaypoint());
    add("GoalList", new GoalList().goals(current).upcoming(List.of(last)));
    add("ObjectDescription", object(new ObjectDescription()).level(ObjectLevel.AVOID_ALWAYS));
    add("PointCloud", cloud());
    add("Circle", object(new Circle().radius(2.5)));
    add("Rectangle", object(new Rectangle().length(8.0).width(3.0).psi(0.5)));
    add("Box", object(new Box().length(8.0).width(3.0).height(2.0).psi(0.5)));
    add("Sphere", object(new Sphere().radius(1.5)));
    add("Cylinder", object(new Cylinder().radius(1.5).height(20.0)).z(-3.0));
    add("Line", object(new Line().points(List.of(Point.of(4, 8, 0), Point.of(5, 9, 0)))));
    add("ObjectList", new ObjectList().objects(List.of(cloud(), object(new Circle().radius(1)))));
    add("NavigationPoint", NavigationPoint.at(Point.of(250.0, -12.5, 3.0)).speed(52.0));
    NavigationPoint arm = NavigationPoint.at(Point.of(0.5, 0.0, -0.25)).subsystem("ARM");
    add("NavigationPoint-arm", arm.referenceFrame(ReferenceFrame.BODY_FLU));
    add("ActuatorCommand", new ActuatorCommand().actuatorName("GRIPPER").expiry(0.5));
    add("PercentageCommand", PercentageCommand.of("AILERON", -12.5).expiry(0.5));
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

  private void addContract() {
    add(
        "ActuatorAnnouncement",
        new ActuatorAnnouncement()
            .actuatorName("AILERON")
            .minimum(-100.0)
            .maximum(100.0)
            .effect("positive rolls right")
            .subsystem("VEHICLE"));
    add("GoalCommand", new GoalCommand().uid("7"));
    add("DiscoveryRequest", new DiscoveryRequest());
    add(
        "DiscoveryResponse",
        new DiscoveryResponse()
            .serviceName("PathPlanner")
            .serviceType("PATH_PLANNER")
            .status(ServiceStatus.RUNNING)
            .host("phone")
            .uptime(12.5)
            .version("0.1.0"));
    add("FunctionalityRequest", new FunctionalityRequest().serviceName("PathPlanner"));
    add(
        "FunctionalityResponse",
        new FunctionalityResponse()
            .serviceName("PathPlanner")
            .publishes(List.of("navigation/NavigationPoint"))
            .subscribes(List.of("state/StateInformation", "goals/GoalList")));
    add("StopCommand", new StopCommand().stopAll(true));
    add("StopCommand-one", new StopCommand().serviceName("PathPlanner"));
    add("ConfigurationRequest", new ConfigurationRequest().serviceName("PathPlanner"));
    ConfigurationVariable variable =
        new ConfigurationVariable()
            .name("LOOK AHEAD")
            .variableType("double")
            .value("250.0")
            .unit("m")
            .min(0.0)
            .max(5000.0)
            .description("Distance of the point to fly to");
    add("ConfigurationVariable", variable);
    add(
        "ConfigurationResponse",
        new ConfigurationResponse().serviceName("PathPlanner").variables(List.of(variable)));
    add(
        "ConfigurationChange",
        new ConfigurationChange()
            .serviceName("PathPlanner")
            .variableName("LOOK AHEAD")
            .value("300.0"));
    add(
        "ConfigurationChangeResult",
        new ConfigurationChangeResult()
            .serviceName("PathPlanner")
            .variableName("LOOK AHEAD")
            .value("250.0")
            .accepted(false)
            .reason("-1.0 m is less than 0"));
    add(
        "HealthReport",
        new HealthReport()
            .serviceName("PathPlanner")
            .status(ServiceStatus.RUNNING)
            .lastError("IllegalStateException: no goals")
            .inboxDepth(3)
            .dropped(70_000)
            .refused(1)
            .overruns(2)
            .exceptions(1)
            .callbackP50(12e-6)
            .callbackP99(0.25e-3));
  }

  private void addFormat2() {
    HealthReport spokenFor =
        new HealthReport().serviceName("Simulator").status(ServiceStatus.RUNNING);
    spokenFor.instance("sim-1").interval(0.25).threadAlive(true).callbackRunning(2.5).dataAge(2.75);
    add("HealthReport-2", spokenFor.published(900).expired(4));
    ConnectionLost lost = new ConnectionLost();
    lost.serviceName("Simulator").status(ServiceStatus.FAILED).lastError("connection lost");
    lost.instance("sim-1").systemId("cessna");
    byName.put("ConnectionLost-will", lost); // a will cannot know its time
    ConnectionLost full = new ConnectionLost();
    full.serviceName("Simulator").status(ServiceStatus.FAILED).lastError("connection lost");
    full.inboxDepth(1)
        .dropped(2)
        .refused(3)
        .overruns(4)
        .exceptions(5)
        .callbackP50(1e-6)
        .callbackP99(1e-3);
    full.instance("sim-1").interval(0.25).threadAlive(false).callbackRunning(0.0).dataAge(3.0);
    add("ConnectionLost", full.published(7).expired(8));
    add(
        "DiscoveryResponse-2",
        new DiscoveryResponse()
            .serviceName("PathPlanner")
            .serviceType("PATH_PLANNER")
            .status(ServiceStatus.RUNNING)
            .instance("planner-2")
            .className("org.u2sa.core.planning.PathPlanner"));
    ConfigurationVariable broker =
        new ConfigurationVariable()
            .name("BROKER")
            .value("embedded")
            .choices(List.of("embedded", "external", "none"));
    add("ConfigurationVariable-2", broker);
    add(
        "ConfigurationResponse-2",
        new ConfigurationResponse()
            .serviceName("PathPlanner")
            .variables(List.of(broker))
            .revision(7));
    HealthReport missing = new HealthReport().serviceName("PathPlanner");
    add("HealthReport-missed", missing.status(ServiceStatus.RUNNING).missed(12));
    ConnectionLost missingToo = new ConnectionLost();
    missingToo.serviceName("PathPlanner").status(ServiceStatus.FAILED).missed(12);
    add("ConnectionLost-missed", missingToo);
    add(
        "EmergencyStop",
        new EmergencyStop().active(true).operator("anna").reason("person on the runway"));
    add("EmergencyStop-clear", new EmergencyStop().operator("anna").clears(MICROS));
    add(
        "ServiceOrder",
        new ServiceOrder()
            .requestId("r-1")
            .serviceName("PathPlanner")
            .action(ServiceAction.SWAP)
            .className("org.example.OtherPlanner")
            .operator("anna"));
    add(
        "ServiceOrderResult",
        new ServiceOrderResult()
            .requestId("r-1")
            .serviceName("PathPlanner")
            .accepted(false)
            .reason("there is no class org.example.OtherPlanner"));
    add(
        "ServiceCondition",
        new ServiceCondition()
            .serviceName("Simulator")
            .condition(Condition.HUNG)
            .since(MICROS)
            .reason("its callback runs for 2.5 s")
            .action("restart 1 of 3")
            .restarts(1)
            .instance("sim-1"));
    add(
        "FailsafeState",
        new FailsafeState()
            .action(FailsafeAction.RETURN)
            .causes(List.of("operator link lost for 5.0 s")));
    add("OperatorHeartbeat", new OperatorHeartbeat().operator("anna").interval(1.0));
    add("ArmCommand", new ArmCommand().requestId("r-2").arm(true).operator("anna"));
    add(
        "ArmingState",
        new ArmingState().armed(false).reasons(List.of("no position")).requestId("r-2"));
    ConfigurationAssignment change =
        new ConfigurationAssignment().variableName("LOOK AHEAD").value("300.0").previous("250.0");
    add("ConfigurationAssignment", change);
    add(
        "ConfigurationTransaction",
        new ConfigurationTransaction()
            .requestId("r-3")
            .serviceName("PathPlanner")
            .assignments(List.of(change))
            .author("anna")
            .revision(7));
    add(
        "ConfigurationUndo",
        new ConfigurationUndo().requestId("r-4").serviceName("PathPlanner").author("anna"));
    add(
        "ConfigurationTransactionResult",
        new ConfigurationTransactionResult()
            .requestId("r-3")
            .serviceName("PathPlanner")
            .accepted(false)
            .reason("revision 7 was expected, but it is 8")
            .assignments(List.of(change))
            .revision(8)
            .author("anna"));
    add(
        "BatteryState",
        new BatteryState().sensorName("Main battery").voltage(12.25).current(-1.5).remaining(80.0));
  }
}
