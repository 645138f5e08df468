package org.u2sa.service;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.u2sa.service.handover.HandOver;

/**
 * The last saved states of one process's services, for restarts in that process while its disk is
 * full or hangs. Thread-safe.
 */
public final class RememberedStates {
  private final Map<String, HandOver> states = new ConcurrentHashMap<>(); // by service name

  void put(String serviceName, HandOver state) {
    states.put(serviceName, state);
  }

  Optional<HandOver> get(String serviceName) {
    return Optional.ofNullable(states.get(serviceName));
  }

  void remove(String serviceName) {
    states.remove(serviceName);
  }
}
