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

/** What a {@link ServiceDirectory} knows of one service at a time. Immutable. */
public final class KnownService {
  private final String name;
  private final DiscoveryResponse discovery; // this and the others: null while not heard
  private final FunctionalityResponse functionality;
  private final HealthReport health;
  private final ServiceCondition condition;

  private KnownService(
      String name,
      DiscoveryResponse discovery,
      FunctionalityResponse functionality,
      HealthReport health,
      ServiceCondition condition) {
    this.name = name;
    this.discovery = discovery;
    this.functionality = functionality;
    this.health = health;
    this.condition = condition;
  }

  static KnownService named(String name) {
    return new KnownService(name, null, null, null, null);
  }

  KnownService with(DiscoveryResponse heard) {
    return new KnownService(name, heard, functionality, health, condition);
  }

  KnownService with(FunctionalityResponse heard) {
    return new KnownService(name, discovery, heard, health, condition);
  }

  KnownService with(HealthReport heard) {
    return new KnownService(name, discovery, functionality, heard, condition);
  }

  KnownService with(ServiceCondition heard) {
    return new KnownService(name, discovery, functionality, health, heard);
  }

  /** Its name, unique in the system. */
  public String name() {
    return name;
  }

  /** Whether it has answered both what it is and what it offers. */
  public boolean isComplete() {
    return discovery != null && functionality != null;
  }

  /** Its answer to discovery: type, host, uptime, version, class. */
  public Optional<DiscoveryResponse> discovery() {
    return Optional.ofNullable(discovery);
  }

  /** Its newest health report, perhaps one that its launcher gave on its behalf. */
  public Optional<HealthReport> health() {
    return Optional.ofNullable(health);
  }

  /** What the health monitor last said of it; empty if the system has none. */
  public Optional<ServiceCondition> condition() {
    return Optional.ofNullable(condition);
  }

  /** Where it is in its life, by its newest word; empty before the first. */
  public Optional<ServiceStatus> status() {
    return health != null
        ? Optional.of(health.status())
        : discovery().map(DiscoveryResponse::status);
  }

  /** Which start of the service this is; empty if it did not say. */
  public Optional<String> instance() {
    Optional<String> reported = health == null ? Optional.empty() : health.instance();
    return reported.isPresent() ? reported : discovery().flatMap(DiscoveryResponse::instance);
  }

  /** Time between its health reports [s]; empty if it did not say. */
  OptionalDouble healthIntervalS() {
    return health == null ? OptionalDouble.empty() : health.interval();
  }

  /** What it publishes; empty while it has not said. */
  public List<DataOffer> publishes() {
    return functionality == null ? Collections.emptyList() : offers(functionality.publishes());
  }

  /** What it subscribes to; empty while it has not said. */
  public List<DataOffer> subscribes() {
    return functionality == null ? Collections.emptyList() : offers(functionality.subscribes());
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
