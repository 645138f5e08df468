package org.u2sa.messages;

import java.util.List;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.EmergencyStop;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;

/** What the third format brought: fields of older messages. */
final class GoldenFormat3 {
  private GoldenFormat3() {}

  static void addTo(GoldenMessages golden) {
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
  }

  private static HealthReport stopped(HealthReport report) {
    return report
        .serviceName("Simulator")
        .status(ServiceStatus.RUNNING)
        .emergencyStops(List.of("anna 1"));
  }
}
