package org.u2sa.messages.schema;

import java.util.List;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.OperatorHeartbeat;

/** What the second format brought: messages, and fields of older ones. */
final class GoldenFormat2 {
  private GoldenFormat2() {}

  static void addTo(GoldenMessages golden) {
    HealthReport spokenFor =
        new HealthReport().serviceName("Simulator").status(ServiceStatus.RUNNING);
    spokenFor.instance("sim-1").interval(0.25).threadAlive(true).callbackRunning(2.5).dataAge(2.75);
    golden.add("HealthReport-2", spokenFor.published(900).expired(4));
    ConnectionLost lost = new ConnectionLost();
    lost.serviceName("Simulator").status(ServiceStatus.FAILED).lastError("connection lost");
    lost.instance("sim-1").systemId("cessna");
    golden.addAsItIs("ConnectionLost-will", lost); // a will cannot know its time
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
    golden.add("ConnectionLost", full.published(7).expired(8));
    golden.add(
        "DiscoveryResponse-2",
        new DiscoveryResponse()
            .serviceName("PathPlanner")
            .serviceType("PATH_PLANNER")
            .status(ServiceStatus.RUNNING)
            .instance("planner-2")
            .className("org.u2sa.core.planning.PathPlanner")); // as it was then
    ConfigurationVariable broker =
        new ConfigurationVariable()
            .name("BROKER")
            .value("embedded")
            .choices(List.of("embedded", "external", "none"));
    golden.add("ConfigurationVariable-2", broker);
    golden.add(
        "ConfigurationResponse-2",
        new ConfigurationResponse()
            .serviceName("PathPlanner")
            .variables(List.of(broker))
            .revision(7));
    HealthReport missing = new HealthReport().serviceName("PathPlanner");
    golden.add("HealthReport-missed", missing.status(ServiceStatus.RUNNING).missed(12));
    ConnectionLost missingToo = new ConnectionLost();
    missingToo.serviceName("PathPlanner").status(ServiceStatus.FAILED).missed(12);
    golden.add("ConnectionLost-missed", missingToo);
    golden.add(
        "EmergencyStop",
        new EmergencyStop().active(true).operator("anna").reason("person on the runway"));
    golden.add(
        "EmergencyStop-clear", new EmergencyStop().operator("anna").clears(GoldenMessages.MICROS));
    golden.add(
        "ServiceOrder",
        new ServiceOrder()
            .requestId("r-1")
            .serviceName("PathPlanner")
            .action(ServiceAction.SWAP)
            .className("org.example.OtherPlanner")
            .operator("anna"));
    golden.add(
        "ServiceOrderResult",
        new ServiceOrderResult()
            .requestId("r-1")
            .serviceName("PathPlanner")
            .accepted(false)
            .reason("there is no class org.example.OtherPlanner"));
    golden.add(
        "ServiceCondition",
        new ServiceCondition()
            .serviceName("Simulator")
            .condition(Condition.HUNG)
            .since(GoldenMessages.MICROS)
            .reason("its callback runs for 2.5 s")
            .action("restart 1 of 3")
            .restarts(1)
            .instance("sim-1"));
    golden.add(
        "FailsafeState",
        new FailsafeState()
            .action(FailsafeAction.RETURN)
            .causes(List.of("operator link lost for 5.0 s")));
    golden.add("OperatorHeartbeat", new OperatorHeartbeat().operator("anna").interval(1.0));
    golden.add("ArmCommand", new ArmCommand().requestId("r-2").arm(true).operator("anna"));
    golden.add(
        "ArmingState",
        new ArmingState().armed(false).reasons(List.of("no position")).requestId("r-2"));
    ConfigurationAssignment change =
        new ConfigurationAssignment().variableName("LOOK AHEAD").value("300.0").previous("250.0");
    golden.add("ConfigurationAssignment", change);
    golden.add(
        "ConfigurationTransaction",
        new ConfigurationTransaction()
            .requestId("r-3")
            .serviceName("PathPlanner")
            .assignments(List.of(change))
            .author("anna")
            .revision(7));
    golden.add(
        "ConfigurationUndo",
        new ConfigurationUndo().requestId("r-4").serviceName("PathPlanner").author("anna"));
    golden.add(
        "ConfigurationTransactionResult",
        new ConfigurationTransactionResult()
            .requestId("r-3")
            .serviceName("PathPlanner")
            .accepted(false)
            .reason("revision 7 was expected, but it is 8")
            .assignments(List.of(change))
            .revision(8)
            .author("anna"));
    golden.add(
        "BatteryState",
        new BatteryState().sensorName("Main battery").voltage(12.25).current(-1.5).remaining(80.0));
  }
}
