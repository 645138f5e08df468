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
 * Snapshot of one service in a {@link ServiceDirectory}.
 *
 * @param health latest report, possibly a substitute by its launcher
 * @param condition last condition by the health monitor
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

  /** Whether it has answered both discovery and functionality requests. */
  public boolean isComplete() {
    return discovery.isPresent() && functionality.isPresent();
  }

  public Optional<ServiceStatus> status() {
    return health.isPresent()
        ? health.map(HealthReport::status)
        : discovery.map(DiscoveryResponse::status);
  }

  /** ID of this start of the service. */
  public Optional<String> instance() {
    Optional<String> reported = health.flatMap(HealthReport::instance);
    return reported.isPresent() ? reported : discovery.flatMap(DiscoveryResponse::instance);
  }

  /** Period of its health reports [s]; empty if unknown. */
  OptionalDouble healthIntervalS() {
    return health.map(HealthReport::interval).orElse(OptionalDouble.empty());
  }

  /** Empty while unknown. */
  public List<DataOffer> publishes() {
    return functionality.map(answer -> offers(answer.publishes())).orElse(List.of());
  }

  /** Empty while unknown. */
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
