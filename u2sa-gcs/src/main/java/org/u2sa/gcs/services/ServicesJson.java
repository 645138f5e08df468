package org.u2sa.gcs.services;

import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.service.directory.DataOffer;
import org.u2sa.service.directory.KnownService;

/** Formats the services of a system as JSON. Unknown values are omitted. */
public final class ServicesJson {
  private ServicesJson() {}

  public static String text(String systemId, DirectoryObservation observation) {
    List<JsonText> services =
        observation.rows().stream()
            .map(row -> service(row, observation.directory().service(row.name())))
            .toList();
    return new JsonText().put("system", systemId).put("services", services).toString();
  }

  private static JsonText service(ServiceRow row, Optional<KnownService> service) {
    JsonText json = new JsonText().put("name", row.name()).put("status", row.status());
    row.discovery().ifPresent(response -> discovery(json, response));
    Optional<KnownService> complete = service.filter(KnownService::isComplete);
    return json.put("publishes", complete.map(each -> offers(each.publishes())))
        .put("subscribes", complete.map(each -> offers(each.subscribes())))
        .put("health", row.health().map(ServicesJson::health))
        .put("condition", row.condition().map(ServicesJson::condition));
  }

  private static void discovery(JsonText json, DiscoveryResponse response) {
    json.put("type", response.serviceType())
        .put("host", response.host())
        .put("uptimeS", response.uptime())
        .put("version", response.version())
        .put("className", response.className())
        .put("instance", response.instance());
  }

  private static List<JsonText> offers(List<DataOffer> offers) {
    return offers.stream()
        .map(
            offer ->
                new JsonText().put("channel", offer.channel()).put("typeChain", offer.typeChain()))
        .toList();
  }

  private static JsonText health(HealthReport report) {
    return new JsonText()
        .put("inbox", report.inboxDepth())
        .put("dropped", report.dropped())
        .put("replaced", report.replaced())
        .put("refused", report.refused())
        .put("overruns", report.overruns())
        .put("exceptions", report.exceptions())
        .put("callbackP50S", report.callbackP50())
        .put("callbackP99S", report.callbackP99())
        .put("commandsObeyed", report.commandsObeyed())
        .put("commandsRefused", report.commandsRefused())
        .put("refusedSubscriptions", report.refusedSubscriptions())
        .put("lastError", report.lastError());
  }

  private static JsonText condition(ServiceCondition condition) {
    return new JsonText()
        .put("condition", condition.condition().name())
        .put("reason", condition.reason())
        .put("action", condition.action())
        .put("restarts", condition.restarts());
  }
}
