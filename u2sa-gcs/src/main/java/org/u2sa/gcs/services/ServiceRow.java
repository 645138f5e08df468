package org.u2sa.gcs.services;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.service.directory.KnownService;

/**
 * One service as shown to operators; unknown values are empty.
 *
 * @param name its name
 * @param type its role, in words
 * @param status its reported status, "no answer" if it does not answer discovery, "gone" if absent
 * @param discovery its discovery response
 * @param health its latest health report
 * @param condition its condition as reported by the health monitor
 */
public record ServiceRow(
    String name,
    String type,
    String status,
    Optional<DiscoveryResponse> discovery,
    Optional<HealthReport> health,
    Optional<ServiceCondition> condition) {

  static ServiceRow of(KnownService service, ServiceCondition condition) {
    Optional<DiscoveryResponse> discovery = service.discovery();
    String status =
        discovery.isEmpty()
            ? "no answer"
            : service.status().map(value -> words(value.name())).orElse("");
    String type = discovery.map(DiscoveryResponse::serviceType).map(ServiceRow::words).orElse("");
    return new ServiceRow(
        service.name(),
        type,
        status,
        discovery,
        service.health(),
        Optional.ofNullable(condition).or(service::condition));
  }

  /** Creates a row for a service known only to the health monitor. */
  static ServiceRow gone(ServiceCondition condition) {
    return new ServiceRow(
        condition.serviceName(),
        "",
        "gone",
        Optional.empty(),
        Optional.empty(),
        Optional.of(condition));
  }

  private static String words(String constant) {
    return constant.toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  /** Simple class name; empty if unknown. */
  public String simpleClassName() {
    String full = discovery.flatMap(DiscoveryResponse::className).orElse("");
    return full.substring(Math.max(full.lastIndexOf('.'), full.lastIndexOf('$')) + 1);
  }

  /** Condition in words, with the countermeasure. */
  public String conditionText() {
    return condition
        .map(
            found ->
                words(found.condition().name())
                    + (found.action().isEmpty() ? "" : " (" + found.action() + ")"))
        .orElse("");
  }

  /** 99th percentile of callback duration [s]. */
  public OptionalDouble callbackP99S() {
    return health.isPresent() ? health.get().callbackP99() : OptionalDouble.empty();
  }

  public String lastError() {
    return health.flatMap(HealthReport::lastError).orElse("");
  }
}
