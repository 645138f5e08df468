package org.u2sa.core.safety;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.schema.U2SAData;

/**
 * Checks that the services and batteries named by variables have reported: a misspelt name would
 * silently disable a failsafe.
 */
final class NamedServices {
  private static final int MAX_NAMES = 500; // so that invented names do not fill the memory

  private final Supplier<SafetyVariables> settings;
  private final Set<String> services = new TreeSet<>();
  private final Set<String> batteries = new TreeSet<>();

  NamedServices(Supplier<SafetyVariables> settings) {
    this.settings = settings;
  }

  void see(U2SAData message) {
    if (message instanceof HealthReport report && services.size() < MAX_NAMES) {
      services.add(report.serviceName());
    } else if (message instanceof BatteryState battery && batteries.size() < MAX_NAMES) {
      batteries.add(battery.sensorName());
    }
  }

  /** The first of ACTUATOR SERVICES that has not reported, in words; empty if all have. */
  Optional<String> unknownActuatorService() {
    return unknown(settings.get().actuatorServices());
  }

  /** The estimator if it has not reported; ignores the default name, which may name none. */
  Optional<String> unknownEstimator() {
    String name = settings.get().estimatorService();
    return name.equals(SafetyVariables.DEFAULT_ESTIMATOR) ? Optional.empty() : unknown(name);
  }

  /** Reason why the values may not replace the current ones in motion; empty if they may. */
  Optional<String> refusal(Map<String, Object> values) {
    SafetyVariables now = settings.get();
    return refusal(values, "ACTUATOR SERVICES", now.actuatorServices(), services)
        .or(() -> refusal(values, "ESTIMATOR SERVICE", now.estimatorService(), services))
        .or(() -> refusal(values, "HEALTH MONITOR SERVICE", now.healthMonitorService(), services))
        .or(() -> refusal(values, "BATTERIES", now.batteries(), batteries));
  }

  private static Optional<String> refusal(
      Map<String, Object> values, String variable, String before, Set<String> reported) {
    String names = (String) values.get(variable);
    return names.equals(before)
        ? Optional.empty()
        : unknown(names, reported)
            .map(
                name ->
                    String.format(
                        "variable \"%s\": \"%s\" has not reported; disarm to set it in advance",
                        variable, name));
  }

  private Optional<String> unknown(String names) {
    return unknown(names, services).map(name -> "service " + name + " has not reported");
  }

  private static Optional<String> unknown(String names, Set<String> reported) {
    return CauseText.names(names).stream().filter(name -> !reported.contains(name)).findFirst();
  }
}
