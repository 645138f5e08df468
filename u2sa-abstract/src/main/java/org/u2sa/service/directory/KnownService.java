package org.u2sa.service.directory;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;

/**
 * What a {@link ServiceDirectory} knows of one service at a time; what was not heard is empty.
 *
 * @param name its name, unique in the system
 * @param discovery its answer to discovery: type, host, uptime, version, class
 * @param functionality its answer to what it publishes and subscribes to
 * @param health its newest health report, perhaps one that its launcher gave on its behalf
 * @param condition what the health monitor last said of it; empty if the system has none
 */
public record KnownService(
    String name,
    Optional<DiscoveryResponse> discovery,
    Optional<FunctionalityResponse> functionality,
    Optional<HealthReport> health,
    Optional<ServiceCondition> condition) {
  static KnownService named(String name) {
    return new KnownService(
        name, Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty());
  }

  KnownService with(DiscoveryResponse heard) {
    return new KnownService(name, Optional.of(heard), functionality, health, condition);
  }

  KnownService with(FunctionalityResponse heard) {
    return new KnownService(name, discovery, Optional.of(heard), health, condition);
  }

  KnownService with(HealthReport heard) {
    return new KnownService(name, discovery, functionality, Optional.of(heard), condition);
  }

  KnownService with(ServiceCondition heard) {
    return new KnownService(name, discovery, functionality, health, Optional.of(heard));
  }

  /** Whether it has answered both what it is and what it offers. */
  public boolean isComplete() {
    return discovery.isPresent() && functionality.isPresent();
  }

  /** Where it is in its life, by its newest word; empty before the first. */
  public Optional<ServiceStatus> status() {
    return health.isPresent()
        ? health.map(HealthReport::status)
        : discovery.map(DiscoveryResponse::status);
  }

  /** Which start of the service this is; empty if it did not say. */
  public Optional<String> instance() {
    Optional<String> reported = health.flatMap(HealthReport::instance);
    return reported.isPresent() ? reported : discovery.flatMap(DiscoveryResponse::instance);
  }

  /** Time between its health reports [s]; empty if it did not say. */
  OptionalDouble healthIntervalS() {
    return health.map(HealthReport::interval).orElse(OptionalDouble.empty());
  }

  /** What it publishes; empty while it has not said. */
  public List<DataOffer> publishes() {
    return functionality.map(answer -> offers(answer.publishes())).orElse(List.of());
  }

  /** What it subscribes to; empty while it has not said. */
  public List<DataOffer> subscribes() {
    return functionality.map(answer -> offers(answer.subscribes())).orElse(List.of());
  }

  private static List<DataOffer> offers(List<String> lines) {
    List<DataOffer> offers = new ArrayList<>();
    lines.forEach(line -> offers.add(DataOffer.parse(line)));
    return Collections.unmodifiableList(offers);
  }

  @Override
  public String toString() {
    return name;
  }
}
