package org.u2sa.gcs.services;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.service.directory.KnownService;

/**
 * One service as operators are shown it; what is not known is empty.
 *
 * @param name its name
 * @param type its role, in words
 * @param status its own word, "no answer" if it answers no discovery, "gone" if it is not there
 * @param discovery its answer to discovery
 * @param health its newest health report
 * @param condition what the health monitor says of it
 */
record ServiceRow(
    String name,
    String type,
    String status,
    Optional<DiscoveryResponse> discovery,
    Optional<HealthReport> health,
    Optional<ServiceCondition> condition) {

  /** A service that was heard. */
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

  /** A service that only the health monitor still knows. */
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

  /** The class's name without its package; empty if it did not say. */
  String simpleClassName() {
    String full = discovery.flatMap(DiscoveryResponse::className).orElse("");
    return full.substring(Math.max(full.lastIndexOf('.'), full.lastIndexOf('$')) + 1);
  }

  /** The condition in words, with what is done about it. */
  String conditionText() {
    return condition
        .map(
            found ->
                words(found.condition().name())
                    + (found.action().isEmpty() ? "" : " (" + found.action() + ")"))
        .orElse("");
  }

  /** Duration that 99 of 100 callbacks do not exceed [s]. */
  OptionalDouble callbackP99S() {
    return health.isPresent() ? health.get().callbackP99() : OptionalDouble.empty();
  }

  /** The last error it knows of. */
  String lastError() {
    return health.flatMap(HealthReport::lastError).orElse("");
  }
}
