package org.u2sa.cli.describe;

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
 * Composition of a vehicle, from its files or while running.
 *
 * @param systemId ID of the vehicle
 * @param origin the system file, or the broker's address
 * @param live whether it was queried while running
 * @param stated autonomy levels stated in its file; empty if not stated
 * @param services services in start order, or sorted by name
 * @param sources observed sensors; only of a running vehicle
 * @param actuators observed actuator announcements, or those they would publish
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

  /** A service. Unknown texts are empty; {@code stated} describes a sensor's data, with units. */
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
    String roleWords() {
      return role.toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }

  /** Data of one source; rateHz is 0 after a single message, and sigmas have units. */
  record HeardSource(
      String channel,
      String sensor,
      String type,
      double rateHz,
      List<String> fields,
      Map<String, String> sigmas) {}

  /** Announcement of an actuator; facts are by field name, with units. */
  record AnnouncedActuator(
      String name, Map<String, String> facts, ActuatorAnnouncement announcement) {
    static AnnouncedActuator of(ActuatorAnnouncement announcement) {
      Map<String, String> facts =
          new LinkedHashMap<>(SourceRecord.facts(announcement, field -> true));
      facts.remove("actuatorName");
      return new AnnouncedActuator(announcement.actuatorName(), facts, announcement);
    }
  }

  List<String> publishersOf(String channel) {
    return names(services.stream().filter(service -> service.publishes().contains(channel)));
  }

  List<String> subscribersOf(String channel) {
    return names(services.stream().filter(service -> service.subscribes().contains(channel)));
  }

  List<String> ofRole(String role) {
    return names(services.stream().filter(service -> service.role().equals(role)));
  }

  private static List<String> names(Stream<ComposedService> of) {
    return of.map(ComposedService::name).collect(Collectors.toList());
  }
}
