package org.u2sa.trials.run;

import java.util.Map;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.core.communication.ManagerVariables;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * The port on which a run's broker accepts other MQTT clients. Runs do not need such clients, so an
 * occupied port is an error only if it was requested explicitly.
 */
final class BrokerPort {
  private static final String MANAGER = "CommunicationManager";
  private static final int HIGHEST_PORT = 65_535;

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  private Integer asked; // null if not given
  private Integer web; // null if not given
  private Integer rosbridge; // null if not given

  @Option(
      names = "--through-broker",
      description =
          "Send all messages between the services through the broker, by MQTT; requires real time.")
  private boolean throughBroker;

  @Option(
      names = "--port",
      paramLabel = "PORT",
      description =
          "TCP port for other MQTT clients; 0: none. Default: the configured port, or any free "
              + "port if it is in use.")
  private void port(int value) {
    if (value < 0 || value > HIGHEST_PORT) {
      throw new ParameterException(
          command.commandLine(), "--port " + value + ": expected 0…" + HIGHEST_PORT);
    }
    asked = value;
  }

  @Option(
      names = "--web",
      paramLabel = "PORT",
      description = "TCP port on which a browser finds the operator's page.")
  private void web(int value) {
    web = port("--web", value);
  }

  @Option(
      names = "--rosbridge",
      paramLabel = "PORT",
      description = "TCP port on which ROS tools connect by the rosbridge protocol (docs/ros.md).")
  private void rosbridge(int value) {
    rosbridge = port("--rosbridge", value);
  }

  private int port(String option, int value) {
    if (value < 1 || value > HIGHEST_PORT) {
      throw new ParameterException(
          command.commandLine(), option + " " + value + ": expected 1…" + HIGHEST_PORT);
    }
    return value;
  }

  /**
   * Sets the Communication Manager's port for a run and reports it if it differs from the
   * configured one.
   */
  public void configure(SystemFile system, LaunchOptions launch, Terminal terminal) {
    if (throughBroker) {
      launch.throughBroker();
    }
    serve(launch, "--web", ManagerVariables.WEB_PORT, web);
    serve(launch, "--rosbridge", ManagerVariables.ROSBRIDGE_PORT, rosbridge);
    if (asked == null) {
      evadeTakenPort(system, launch, terminal);
    } else if (asked == 0) {
      launch.override(MANAGER, ManagerVariables.BROKER, "none");
    } else {
      launch.override(MANAGER, ManagerVariables.PORT, asked);
    }
  }

  private void serve(LaunchOptions launch, String option, String variable, Integer port) {
    if (port == null) {
      return;
    }
    if (asked != null && asked == 0) {
      throw new ParameterException(
          command.commandLine(), option + " needs a broker, but --port 0 disables it");
    }
    launch.override(MANAGER, variable, port);
  }

  private static void evadeTakenPort(SystemFile system, LaunchOptions launch, Terminal terminal) {
    int port =
        system
            .communication()
            .map(XmlConfiguration::load)
            .orElseGet(() -> XmlConfiguration.inMemory(MANAGER, Map.of()))
            .settings(ManagerVariables.class)
            .get()
            .communicationManagerPort();
    launch.anyPortIfTaken(
        other ->
            terminal
                .out()
                .println(
                    "Port "
                        + port
                        + " is taken by another program; MQTT clients find this flight on port "
                        + other
                        + " (--port chooses one)."));
  }
}
