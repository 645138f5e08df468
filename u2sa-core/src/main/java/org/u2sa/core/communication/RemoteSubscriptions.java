package org.u2sa.core.communication;

import io.moquette.broker.subscriptions.Topic;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Who elsewhere listens to what, so that nothing is encoded for nobody. Safe for several threads.
 */
final class RemoteSubscriptions {
  private final Map<String, Set<String>> filtersByClient = new ConcurrentHashMap<>();
  private final AtomicInteger version = new AtomicInteger();

  void add(String clientId, String filter) {
    filtersByClient.computeIfAbsent(clientId, id -> ConcurrentHashMap.newKeySet()).add(filter);
    version.incrementAndGet();
  }

  void remove(String clientId, String filter) {
    Set<String> filters = filtersByClient.get(clientId);
    if (filters != null && filters.remove(filter)) {
      version.incrementAndGet();
    }
  }

  void remove(String clientId) {
    if (filtersByClient.remove(clientId) != null) {
      version.incrementAndGet();
    }
  }

  /** Changes with every change, so that answers of {@link #wants} may be remembered. */
  int version() {
    return version.get();
  }

  /** Whether any client listens to the topic. */
  boolean wants(String topic) {
    Topic published = new Topic(topic);
    return filtersByClient.values().stream()
        .anyMatch(
            filters -> filters.stream().anyMatch(filter -> published.match(new Topic(filter))));
  }
}
