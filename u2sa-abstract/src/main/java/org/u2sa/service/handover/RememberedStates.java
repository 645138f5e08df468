package org.u2sa.service.handover;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The last saved states of one process's services, for restarts in that process while its disk is
 * full or hangs. Thread-safe.
 */
public final class RememberedStates {
  private final Map<String, HandOver> states = new ConcurrentHashMap<>(); // by service name

  /** Stores the state of a service, replacing its earlier one. */
  public void put(String serviceName, HandOver state) {
    states.put(serviceName, state);
  }

  /** The state of a service; empty if none is kept. */
  public Optional<HandOver> get(String serviceName) {
    return Optional.ofNullable(states.get(serviceName));
  }

  /** Forgets the state of a service. */
  public void remove(String serviceName) {
    states.remove(serviceName);
  }
}
