package org.u2sa.messages.schema;

import java.util.List;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationChangeResult;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.safety.StopCommand;

/** Messages of the service contract as the first format had it. */
final class GoldenContract {
  private GoldenContract() {}

  static void addTo(GoldenMessages golden) {
    golden.add(
        "ActuatorAnnouncement",
        new ActuatorAnnouncement()
            .actuatorName("AILERON")
            .minimum(-100.0)
            .maximum(100.0)
            .effect("positive rolls right")
            .subsystem("VEHICLE"));
    golden.add("GoalCommand", new GoalCommand().uid("7"));
    golden.add("DiscoveryRequest", new DiscoveryRequest());
    golden.add(
        "DiscoveryResponse",
        new DiscoveryResponse()
            .serviceName("PathPlanner")
            .serviceType("PATH_PLANNER")
            .status(ServiceStatus.RUNNING)
            .host("phone")
            .uptime(12.5)
            .version("0.1.0"));
    golden.add("FunctionalityRequest", new FunctionalityRequest().serviceName("PathPlanner"));
    golden.add(
        "FunctionalityResponse",
        new FunctionalityResponse()
            .serviceName("PathPlanner")
            .publishes(List.of("navigation/NavigationPoint"))
            .subscribes(List.of("state/StateInformation", "goals/GoalList")));
    golden.add("StopCommand", new StopCommand().stopAll(true));
    golden.add("StopCommand-one", new StopCommand().serviceName("PathPlanner"));
    golden.add("ConfigurationRequest", new ConfigurationRequest().serviceName("PathPlanner"));
    ConfigurationVariable variable =
        new ConfigurationVariable()
            .name("LOOK AHEAD")
            .variableType("double")
            .value("250.0")
            .unit("m")
            .min(0.0)
            .max(5000.0)
            .description("Distance of the point to fly to");
    golden.add("ConfigurationVariable", variable);
    golden.add(
        "ConfigurationResponse",
        new ConfigurationResponse().serviceName("PathPlanner").variables(List.of(variable)));
    golden.add(
        "ConfigurationChange",
        new ConfigurationChange()
            .serviceName("PathPlanner")
            .variableName("LOOK AHEAD")
            .value("300.0"));
    golden.add(
        "ConfigurationChangeResult",
        new ConfigurationChangeResult()
            .serviceName("PathPlanner")
            .variableName("LOOK AHEAD")
            .value("250.0")
            .accepted(false)
            .reason("-1.0 m is less than 0"));
    golden.add(
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
}
