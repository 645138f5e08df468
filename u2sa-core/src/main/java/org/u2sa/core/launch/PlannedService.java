package org.u2sa.core.launch;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.service.U2SAService;
import org.u2sa.service.actuator.ActuatorOwner;

/**
 * Description of a service of a system file as it would run: created with its configuration,
 * inspected, and never started.
 *
 * @param entry entry in the system file
 * @param name service name, or class name if it could not be created
 * @param role name of its {@link org.u2sa.service.ServiceRole}; empty if it could not be created
 * @param publishes channels on which it would publish
 * @param subscribes channels to which it would subscribe
 * @param variables declared variables with their configured values
 * @param actuators its actuator announcements
 * @param refusal why it could not be created here, such as a missing device or jar; empty if it was
 */
public record PlannedService(
    SystemFile.Entry entry,
    String name,
    String role,
    List<Channel<?>> publishes,
    List<Channel<?>> subscribes,
    List<ConfigurationVariable> variables,
    List<ActuatorAnnouncement> actuators,
    Optional<String> refusal) {
  public PlannedService {
    variables = List.copyOf(variables);
    actuators = List.copyOf(actuators);
    publishes = List.copyOf(publishes);
    subscribes = List.copyOf(subscribes);
  }

  /**
   * All services of a system.
   *
   * @throws IOException if their log files cannot be created
   */
  public static List<PlannedService> of(SystemFile system) throws IOException {
    try (TemporaryFolder logs = TemporaryFolder.create("u2sa-describe")) {
      LaunchOptions options = new LaunchOptions().logDirectory(logs.path());
      ServiceMaker maker =
          new ServiceMaker(
              system.systemId(),
              options,
              MessageTypes.discovered(),
              new LocalBus(system.systemId()));
      return system.services().stream()
          .map(entry -> planned(maker, entry))
          .collect(Collectors.toList());
    }
  }

  private static PlannedService planned(ServiceMaker maker, SystemFile.Entry entry) {
    XmlConfiguration configuration = maker.configuration(entry); // throws: not machine-specific
    try {
      U2SAService service = maker.make(entry, configuration);
      PlannedService planned =
          new PlannedService(
              entry,
              service.getServiceName(),
              service.role().name(),
              service.publishedChannels(),
              service.subscribedChannels(),
              configuration.describe(),
              service instanceof ActuatorOwner owner ? owner.actuators() : List.of(),
              Optional.empty());
      service.shutDown();
      return planned;
    } catch (RuntimeException | LinkageError e) { // missing device or jar
      return new PlannedService(
          entry,
          entry.simpleName(),
          "",
          List.of(),
          List.of(),
          List.of(),
          List.of(),
          Optional.of(String.valueOf(e.getMessage())));
    }
  }
}
