package org.u2sa.gcs.describe;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.core.launch.AutonomyLevels;
import org.u2sa.messages.contract.ActuatorAnnouncement;

/**
 * What a vehicle is made of, by its files or as it runs.
 *
 * @param systemId the vehicle
 * @param origin the system file, or the broker's address
 * @param live whether it was asked while it runs
 * @param stated the levels of autonomy that its file states; empty if it states none
 * @param services in the order in which they are started, or by name
 * @param sources what was heard of sensors; only of a vehicle that runs
 * @param actuators what was heard of actuators, or what they would announce
 */
record VehicleComposition(
    String systemId,
    String origin,
    boolean live,
    Optional<AutonomyLevels> stated,
    List<ComposedService> services,
    List<HeardSource> sources,
    List<AnnouncedActuator> actuators) {
  VehicleComposition {
    services = List.copyOf(services);
    sources = List.copyOf(sources);
    actuators = List.copyOf(actuators);
  }

  /**
   * A service of it.
   *
   * @param role by {@link org.u2sa.service.ServiceRole}'s name; empty if it is not known
   * @param configuration its file; empty if it has none, or if it is not known
   * @param variables what the file sets, by name, with unit
   * @param stated what the configuration states of a sensor's data, by variable, with unit; only of
   *     a file
   * @param publishes the channels on which it publishes
   * @param subscribes the channels that it hears
   * @param note what is to be said besides; empty if nothing
   */
  record ComposedService(
      String name,
      String role,
      String className,
      String configuration,
      Map<String, String> variables,
      Map<String, String> stated,
      List<String> publishes,
      List<String> subscribes,
      String note) {
    /** The role in words. */
    String roleWords() {
      return role.toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }

  /**
   * What one sensor, or the estimator, measures.
   *
   * @param channel where
   * @param sensor its name
   * @param type of its messages
   * @param rateHz how often it was heard; 0 if only once
   * @param fields the fields that it sets
   * @param sigmas the standard deviations that it gives, with unit
   */
  record HeardSource(
      String channel,
      String sensor,
      String type,
      double rateHz,
      List<String> fields,
      Map<String, String> sigmas) {}

  /**
   * What an actuator says it can do.
   *
   * @param facts what it announces, by the field's name, with unit
   */
  record AnnouncedActuator(
      String name, Map<String, String> facts, ActuatorAnnouncement announcement) {
    static AnnouncedActuator of(ActuatorAnnouncement announcement) {
      Map<String, String> facts =
          new LinkedHashMap<>(SourceRecord.facts(announcement, field -> true));
      facts.remove("actuatorName");
      return new AnnouncedActuator(announcement.actuatorName(), facts, announcement);
    }
  }

  /** The services that publish on a channel. */
  List<String> publishersOf(String channel) {
    return names(services.stream().filter(service -> service.publishes().contains(channel)));
  }

  /** The services that hear a channel. */
  List<String> subscribersOf(String channel) {
    return names(services.stream().filter(service -> service.subscribes().contains(channel)));
  }

  /** The services of a role. */
  List<String> ofRole(String role) {
    return names(services.stream().filter(service -> service.role().equals(role)));
  }

  private static List<String> names(Stream<ComposedService> of) {
    return of.map(ComposedService::name).collect(Collectors.toList());
  }
}
