package org.u2sa.cli.describe;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.u2sa.cli.describe.VehicleComposition.ComposedService;
import org.u2sa.core.launch.AutonomyLevels.Level;
import org.u2sa.interfaces.JsonText;

/** Formats a vehicle's composition as JSON. Unknown values are omitted. */
final class DescriptionJson {
  private DescriptionJson() {}

  static String text(VehicleComposition vehicle) {
    JsonText autonomy = new JsonText();
    for (AutonomyEvidence.Finding finding : new AutonomyEvidence(vehicle).findings()) {
      autonomy.put(
          finding.dimension(),
          new JsonText()
              .put("stated", finding.stated().map(DescriptionJson::level))
              .put("shown", level(finding.shown()))
              .put("because", finding.because()));
    }
    JsonText json =
        new JsonText()
            .put("system", vehicle.systemId())
            .put("origin", vehicle.origin())
            .put("live", vehicle.live())
            .put("autonomy", autonomy)
            .put(
                "services",
                vehicle.services().stream().map(each -> service(each, vehicle)).toList());
    if (vehicle.live()) {
      json.put("sources", sources(vehicle));
    }
    return json.put("actuators", actuators(vehicle)).toString();
  }

  private static JsonText level(Level level) {
    return new JsonText().put("level", level.number()).put("name", level.words());
  }

  private static JsonText service(ComposedService service, VehicleComposition vehicle) {
    return new JsonText()
        .put("name", service.name())
        .put("role", known(service.role()))
        .put("className", known(service.className()))
        .put("configuration", known(service.configuration()))
        .put("variables", known(service.variables()))
        .put("states", known(service.stated()))
        .put("subscribes", channels(service.subscribes(), "from", vehicle::publishersOf))
        .put("publishes", channels(service.publishes(), "to", vehicle::subscribersOf))
        .put("note", known(service.note()));
  }

  private static List<JsonText> channels(
      List<String> channels, String direction, Function<String, List<String>> ends) {
    return channels.stream()
        .map(each -> new JsonText().put("channel", each).put(direction, ends.apply(each)))
        .toList();
  }

  private static List<JsonText> sources(VehicleComposition vehicle) {
    return vehicle.sources().stream()
        .map(
            source ->
                new JsonText()
                    .put("channel", source.channel())
                    .put("sensor", known(source.sensor()))
                    .put("type", source.type())
                    .put("rateHz", source.rateHz())
                    .put("fields", source.fields())
                    .put("sigmas", texts(source.sigmas())))
        .toList();
  }

  private static List<JsonText> actuators(VehicleComposition vehicle) {
    return vehicle.actuators().stream()
        .map(
            actuator ->
                new JsonText()
                    .put("name", actuator.name())
                    .put("announces", texts(actuator.facts())))
        .toList();
  }

  private static Optional<String> known(String text) {
    return Optional.of(text).filter(each -> !each.isEmpty());
  }

  private static Optional<JsonText> known(Map<String, String> values) {
    return values.isEmpty() ? Optional.empty() : Optional.of(texts(values));
  }

  private static JsonText texts(Map<String, String> values) {
    JsonText json = new JsonText();
    values.forEach(json::put);
    return json;
  }
}
