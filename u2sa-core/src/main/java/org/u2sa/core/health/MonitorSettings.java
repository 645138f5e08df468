package org.u2sa.core.health;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** The health monitor's variables, and what they say of each service. */
final class MonitorSettings {
  static final VariableDeclaration<String> WATCHED =
      VariableDeclaration.text("WATCHED")
          .ifAbsent("")
          .describedAs(
              "Names of the services that are watched, separated by commas; they are missed if they never appear. "
                  + "Empty: every service that was ever heard.");

  static final VariableDeclaration<Double> HUNG_AFTER =
      VariableDeclaration.number("HUNG AFTER", "s")
          .range(Range.of(0.1, 3600.0))
          .ifAbsent(2.0)
          .describedAs("Time that a callback may run before its service counts as hung.");

  static final VariableDeclaration<Double> LOST_AFTER =
      VariableDeclaration.number("LOST AFTER", "s")
          .range(Range.of(0.1, 3600.0))
          .ifAbsent(4.0)
          .describedAs("Time without a word of a service after which it counts as lost.");

  static final VariableDeclaration<Double> RECONNECT_WITHIN =
      VariableDeclaration.number("RECONNECT WITHIN", "s")
          .range(Range.of(0.0, 3600.0))
          .ifAbsent(4.0)
          .describedAs(
              "Time that a service whose connection broke, while nobody says that its process has ended, has to connect again before it is restarted.");

  static final VariableDeclaration<Double> START_WITHIN =
      VariableDeclaration.number("START WITHIN", "s")
          .range(Range.of(0.1, 3600.0))
          .ifAbsent(15.0)
          .describedAs(
              "Time that a service has to be heard after the monitor's start or an order to start it.");

  static final VariableDeclaration<Double> RESTART_DELAY =
      VariableDeclaration.number("RESTART DELAY", "s")
          .range(Range.of(0.0, 3600.0))
          .ifAbsent(0.25)
          .describedAs(
              "Delay of the first restart; each further one within the window waits twice.");

  static final VariableDeclaration<Integer> RESTART_LIMIT =
      VariableDeclaration.integer("RESTART LIMIT")
          .range(Range.of(1, 1000))
          .ifAbsent(3)
          .describedAs("Restarts of a service within the window before it is given up.");

  static final VariableDeclaration<Double> RESTART_WINDOW =
      VariableDeclaration.number("RESTART WINDOW", "s")
          .range(Range.of(1.0, 86_400.0))
          .ifAbsent(60.0)
          .describedAs("Time in which restarts are counted.");

  static final VariableDeclaration<String> AFTER_RESTARTS =
      VariableDeclaration.text("AFTER RESTARTS")
          .oneOf(Policy.ALERT.name(), Policy.FAILSAFE.name())
          .ifAbsent(Policy.FAILSAFE.name())
          .describedAs("What follows when restarts did not help.");

  private static final String POLICY = "POLICY";
  private static final String DATA_TIMEOUT = "DATA TIMEOUT";

  private final Set<String> watched = new LinkedHashSet<>();
  private final Map<String, Policy> policies = new HashMap<>();
  private final Map<String, Double> dataTimeoutsS = new HashMap<>();
  private final Policy policy;
  private final double dataTimeoutS;
  private final double hungAfterS;
  private final double lostAfterS;
  private final double reconnectWithinS;
  private final double startWithinS;
  private final double restartDelayS;
  private final int restartLimit;
  private final double restartWindowS;
  private final Policy afterRestarts;

  /** Reads all variables, also those of the services that the configuration names. */
  MonitorSettings(Configurator configuration) {
    for (String name : configuration.getVariable(WATCHED).split(",", -1)) {
      if (!name.trim().isEmpty()) {
        watched.add(name.trim());
      }
    }
    hungAfterS = configuration.getVariable(HUNG_AFTER);
    lostAfterS = configuration.getVariable(LOST_AFTER);
    reconnectWithinS = configuration.getVariable(RECONNECT_WITHIN);
    startWithinS = configuration.getVariable(START_WITHIN);
    restartDelayS = configuration.getVariable(RESTART_DELAY);
    restartLimit = configuration.getVariable(RESTART_LIMIT);
    restartWindowS = configuration.getVariable(RESTART_WINDOW);
    afterRestarts = Policy.valueOf(configuration.getVariable(AFTER_RESTARTS));
    policy = Policy.valueOf(configuration.getVariable(policy("", Policy.RESTART.name())));
    dataTimeoutS = configuration.getVariable(dataTimeout("", 0.0));
    for (String service : named(configuration)) {
      policies.put(
          service, Policy.valueOf(configuration.getVariable(policy(service, policy.name()))));
      dataTimeoutsS.put(service, configuration.getVariable(dataTimeout(service, dataTimeoutS)));
    }
  }

  private Set<String> named(Configurator configuration) {
    Set<String> names = new LinkedHashSet<>(watched);
    for (Map.Entry<String, Object> entry : configuration.enumerateFields()) {
      for (String suffix : List.of(" " + POLICY, " " + DATA_TIMEOUT)) {
        if (entry.getKey().endsWith(suffix)) {
          names.add(entry.getKey().substring(0, entry.getKey().length() - suffix.length()));
        }
      }
    }
    return names;
  }

  private static VariableDeclaration<String> policy(String service, String otherwise) {
    return VariableDeclaration.text(service.isEmpty() ? POLICY : service + " " + POLICY)
        .oneOf(Policy.RESTART.name(), Policy.ALERT.name(), Policy.FAILSAFE.name())
        .ifAbsent(otherwise)
        .describedAs("What is done about " + subject(service) + " that no longer works.");
  }

  private static VariableDeclaration<Double> dataTimeout(String service, double otherwise) {
    return VariableDeclaration.number(
            service.isEmpty() ? DATA_TIMEOUT : service + " " + DATA_TIMEOUT, "s")
        .range(Range.of(0.0, 3600.0))
        .ifAbsent(otherwise)
        .describedAs(
            "Time without data after which " + subject(service) + " counts as stalled; 0: never.");
  }

  private static String subject(String service) {
    return service.isEmpty() ? "a service" : "service " + service;
  }

  /** Services that must be there; empty: whoever is heard is watched. */
  Set<String> watched() {
    return watched;
  }

  boolean watches(String service) {
    return watched.isEmpty() || watched.contains(service);
  }

  Policy policyOf(String service) {
    return policies.getOrDefault(service, policy);
  }

  /** Time without data after which the service is stalled [s]; 0: never. */
  double dataTimeoutS(String service) {
    return dataTimeoutsS.getOrDefault(service, dataTimeoutS);
  }

  double hungAfterS() {
    return hungAfterS;
  }

  double lostAfterS() {
    return lostAfterS;
  }

  double reconnectWithinS() {
    return reconnectWithinS;
  }

  double startWithinS() {
    return startWithinS;
  }

  /** How long to wait before a restart [s], after that many within the window. */
  double delayS(int restartsBefore) {
    return restartDelayS * Math.pow(2.0, restartsBefore);
  }

  int restartLimit() {
    return restartLimit;
  }

  double restartWindowS() {
    return restartWindowS;
  }

  Policy afterRestarts() {
    return afterRestarts;
  }
}
