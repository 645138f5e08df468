package org.u2sa.core.health;

import static org.u2sa.messages.cbor.Limits.NAME_CHARS;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** Variables of the health monitor, global and per service. */
final class MonitorVariables {
  /** Variables that apply to all services. */
  record Limits(
      @Variable(ifAbsentText = "")
          @Description(
              "Names of the watched services, separated by commas; one that never appears is reported. Empty: every service that has ever reported.")
          String watched,
      @Variable(unit = "s", min = 0.1, max = 3600, ifAbsent = 2)
          @Description("Time that a callback may run before its service counts as hung.")
          double hungAfter,
      @Variable(unit = "s", min = 0.1, max = 3600, ifAbsent = 4)
          @Description("Silence after which a service counts as lost.")
          double lostAfter,
      // One connection attempt that hangs for 4 s, plus a back-off of 2 s.
      @Variable(unit = "s", min = 0, max = 3600, ifAbsent = 6)
          @Description(
              "Time to reconnect before a restart, for a service whose connection broke but whose process is not known to have ended.")
          double reconnectWithin,
      @Variable(unit = "s", min = 0.1, max = 3600, ifAbsent = 15)
          @Description(
              "Time within which a service must report after the monitor starts or orders its start.")
          double startWithin,
      @Variable(unit = "s", min = 0, max = 3600, ifAbsent = 0.25)
          @Description(
              "Delay of the first restart; doubles with each further one within the window.")
          double restartDelay,
      @Variable(min = 1, max = 1000, ifAbsent = 3)
          @Description("Restarts of a service within the window before the monitor gives up.")
          int restartLimit,
      @Variable(unit = "s", min = 1, max = 86_400, ifAbsent = 60)
          @Description("Restart-count window.")
          double restartWindow,
      @Variable(
              oneOf = {"ALERT", "FAILSAFE"},
              ifAbsentText = "FAILSAFE")
          @Description("Action when restarts have not helped.")
          String afterRestarts,
      @Variable(ifAbsentText = "RESTART") @Description("Action if a service no longer works.")
          Policy policy,
      @Variable(unit = "s", min = 0, max = 3600, ifAbsent = 0)
          @Description("Time without data after which a service counts as stalled; 0: never.")
          double dataTimeout,
      @Variable(
              oneOf = {"CONTINUE", "HOLD", "RETURN", "LAND"},
              ifAbsentText = "HOLD")
          @Description(
              "Failsafe that the monitor itself demands if the Safety Manager of an armed vehicle is lost.")
          String onSafetyManagerLoss,
      // Above LOST AFTER; below ARMING EXPIRY, or actuators would be neutral already.
      @Variable(unit = "s", min = 1.5, max = 3600, ifAbsent = 5)
          @Description(
              "Time without an arming state after which the Safety Manager of an armed vehicle counts as lost.")
          double safetyManagerDeadline,
      @Variable(unit = "s", min = 0.01, max = 60, ifAbsent = 1)
          @Description(
              "Maximum difference of a service's clock from the monitor's before it is reported.")
          double clockTolerance) {}

  static final String WATCHED = "WATCHED";
  private static final String POLICY = " POLICY";
  private static final String DATA_TIMEOUT = " DATA TIMEOUT";

  final Limits limits;
  final Set<String> watched = new LinkedHashSet<>();
  private final Map<String, Policy> policies = new HashMap<>();
  private final Map<String, Double> dataTimeoutsS = new HashMap<>();

  /** Also reads the variables of the services named in the configuration. */
  MonitorVariables(Limits limits, Configurator configuration) {
    this.limits = limits;
    nameRefusal(limits.watched())
        .ifPresent(
            reason -> {
              throw new BadInputException(reason);
            });
    watched.addAll(names(limits.watched()));
    for (String service : named(configuration)) {
      policies.put(service, Policy.valueOf(configuration.getVariable(policy(service))));
      dataTimeoutsS.put(service, configuration.getVariable(dataTimeout(service)));
    }
  }

  private static Set<String> names(String list) {
    Set<String> names = new LinkedHashSet<>();
    for (String name : list.split(",", -1)) {
      if (!name.trim().isEmpty()) {
        names.add(name.trim());
      }
    }
    return names;
  }

  /** Reason why a list of watched services is invalid: a name that no message can carry. */
  static Optional<String> nameRefusal(String list) {
    return names(list).stream()
        .filter(name -> name.length() > NAME_CHARS)
        .findFirst()
        .map(
            name ->
                String.format(
                    "%s: a name of %d characters; expected at most %d",
                    WATCHED, name.length(), NAME_CHARS));
  }

  /** Reason why a list of watched services is invalid: one has not reported. */
  static Optional<String> unknown(String list, Set<String> reported) {
    return names(list).stream()
        .filter(name -> !reported.contains(name))
        .findFirst()
        .map(
            name ->
                String.format(
                    "%s: \"%s\" has not reported; disarm to set it in advance", WATCHED, name));
  }

  private Set<String> named(Configurator configuration) {
    Set<String> names = new LinkedHashSet<>(watched);
    for (Map.Entry<String, Object> entry : configuration.enumerateFields()) {
      for (String suffix : List.of(POLICY, DATA_TIMEOUT)) {
        if (entry.getKey().endsWith(suffix)) {
          names.add(entry.getKey().substring(0, entry.getKey().length() - suffix.length()));
        }
      }
    }
    return names;
  }

  private VariableDeclaration<String> policy(String service) {
    return VariableDeclaration.text(service + POLICY)
        .oneOf(Policy.RESTART.name(), Policy.ALERT.name(), Policy.FAILSAFE.name())
        .ifAbsent(limits.policy().name())
        .describedAs("What to do about service " + service + " when it no longer works.");
  }

  private VariableDeclaration<Double> dataTimeout(String service) {
    return VariableDeclaration.number(service + DATA_TIMEOUT, "s")
        .range(Range.of(0.0, 3600.0))
        .ifAbsent(limits.dataTimeout())
        .describedAs(
            "Time without data after which service " + service + " counts as stalled; 0: never.");
  }

  boolean watches(String service) {
    return watched.isEmpty() || watched.contains(service);
  }

  Policy policyOf(String service) {
    return policies.getOrDefault(service, limits.policy());
  }

  /** Time without data after which the service is stalled [s]; 0 for never. */
  double dataTimeoutS(String service) {
    return dataTimeoutsS.getOrDefault(service, limits.dataTimeout());
  }

  /** Back-off delay before a restart [s], given the number of restarts within the window. */
  double delayS(int restartsBefore) {
    return limits.restartDelay() * Math.pow(2.0, restartsBefore);
  }

  Policy afterRestarts() {
    return Policy.valueOf(limits.afterRestarts());
  }
}
