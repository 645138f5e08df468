package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.service.handover.HandOver;

/** Condition of each service, as published by the health monitor. */
final class Conditions {
  /** Conditions that do not count as failed. A silent service may still be alive. */
  private static final Set<Condition> WORKING = EnumSet.of(Condition.ALIVE, Condition.SILENT);

  /** Prefix of the health monitor's action for services it gives up. */
  private static final String GIVEN_UP = "failsafe";

  private static final String FAILED = "failed services";

  private final Map<String, ServiceCondition> newest = new TreeMap<>();

  void see(ServiceCondition condition) {
    if (condition.condition() == Condition.UNWATCHED) {
      newest.remove(condition.serviceName());
    } else {
      newest.put(condition.serviceName(), condition);
    }
  }

  void handOver(HandOver state) {
    state.messages(FAILED, failed());
  }

  /** Restores the failed services, which count as failed until a newer condition arrives. */
  void takeOver(HandOver state) {
    state.messages(FAILED, ServiceCondition.class).forEach(this::see);
  }

  /** The part of the state that must be saved whenever it changes. */
  String saved() {
    return failed().stream().map(Conditions::words).collect(Collectors.joining());
  }

  private List<ServiceCondition> failed() {
    return newest.values().stream()
        .filter(condition -> !WORKING.contains(condition.condition()))
        .collect(Collectors.toList());
  }

  /**
   * Fault of the first of these services that has failed; empty if none is known to have failed.
   *
   * @param services comma-separated names
   */
  Optional<String> failure(String services) {
    return CauseText.names(services).stream()
        .filter(newest::containsKey)
        .map(newest::get)
        .filter(condition -> !WORKING.contains(condition.condition()))
        .map(Conditions::words)
        .findFirst();
  }

  /** A service that the health monitor has given up, by policy or after failed restarts. */
  Optional<String> givenUp() {
    return failed().stream()
        .filter(condition -> condition.action().startsWith(GIVEN_UP))
        .findFirst()
        .map(Conditions::words);
  }

  List<String> notAlive() {
    List<String> all = new ArrayList<>();
    for (ServiceCondition condition : newest.values()) {
      if (condition.condition() != Condition.ALIVE) {
        all.add(words(condition));
      }
    }
    return all;
  }

  private static String words(ServiceCondition condition) {
    String reason = condition.reason();
    return String.format(
        "service %s is %s%s",
        condition.serviceName(), condition.condition(), reason.isEmpty() ? "" : ": " + reason);
  }
}
