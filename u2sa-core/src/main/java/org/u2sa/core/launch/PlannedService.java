package org.u2sa.core.launch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.service.ActuatorOwner;
import org.u2sa.service.U2SAService;

/**
 * A service of a system file as it would run: it is made with its configuration, asked what it is,
 * and never started.
 *
 * @param entry where the file lists it
 * @param name its name; the class's if it could not be made
 * @param role what it is for, by {@link org.u2sa.service.ServiceRole}'s name; empty if it could not
 *     be made
 * @param publishes the channels on which it would publish
 * @param subscribes the channels that it would hear
 * @param variables all that it declares, with their values here
 * @param actuators what it would announce of each
 * @param refusal why it could not be made here, as for want of a device or jar; empty if it was
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
    variables = Collections.unmodifiableList(new ArrayList<>(variables));
    actuators = Collections.unmodifiableList(new ArrayList<>(actuators));
    publishes = Collections.unmodifiableList(new ArrayList<>(publishes));
    subscribes = Collections.unmodifiableList(new ArrayList<>(subscribes));
  }

  /**
   * All services of a system.
   *
   * @throws IOException if there is no room for their log files
   */
  public static List<PlannedService> of(SystemFile system) throws IOException {
    Path logs = Files.createTempDirectory("u2sa-describe");
    try {
      LaunchOptions options = new LaunchOptions().logDirectory(logs);
      ServiceMaker maker =
          new ServiceMaker(
              system.systemId(),
              options,
              MessageTypes.discovered(),
              new LocalBus(system.systemId()));
      return system.services().stream()
          .map(entry -> planned(maker, entry))
          .collect(Collectors.toList());
    } finally {
      delete(logs);
    }
  }

  private static PlannedService planned(ServiceMaker maker, SystemFile.Entry entry) {
    XmlConfiguration configuration = maker.configuration(entry); // wrong on any machine, if wrong
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
              service instanceof ActuatorOwner
                  ? ((ActuatorOwner) service).actuators()
                  : Collections.emptyList(),
              Optional.empty());
      service.shutDown();
      return planned;
    } catch (RuntimeException | LinkageError e) { // a device, a jar that is not here
      return new PlannedService(
          entry,
          entry.simpleName(),
          "",
          Collections.emptyList(),
          Collections.emptyList(),
          Collections.emptyList(),
          Collections.emptyList(),
          Optional.of(String.valueOf(e.getMessage())));
    }
  }

  private static void delete(Path folder) throws IOException {
    List<Path> files;
    try (Stream<Path> all = Files.walk(folder)) {
      files = all.sorted(Comparator.reverseOrder()).collect(Collectors.toList());
    }
    for (Path file : files) {
      Files.deleteIfExists(file);
    }
  }
}
