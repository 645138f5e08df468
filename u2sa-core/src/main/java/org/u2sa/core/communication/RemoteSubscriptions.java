package org.u2sa.core.communication;

import io.moquette.broker.subscriptions.Topic;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Who elsewhere listens to what, by connection, so that nothing is encoded for nobody. A filter is
 * entered before Moquette sees it: when its client has the answer, it misses nothing any more. Safe
 * for several threads.
 */
final class RemoteSubscriptions {
  private final Map<String, Map<String, Topic>> filters = new ConcurrentHashMap<>();
  private final AtomicInteger version = new AtomicInteger();

  /** Enters a filter; one that is none is left to Moquette to refuse. */
  void add(String connection, String filter) {
    Topic parsed = new Topic(filter);
    if (parsed.isValid()) {
      filters.computeIfAbsent(connection, id -> new ConcurrentHashMap<>()).put(filter, parsed);
      version.incrementAndGet();
    }
  }

  void remove(String connection, String filter) {
    Map<String, Topic> its = filters.get(connection);
    if (its != null && its.remove(filter) != null) {
      version.incrementAndGet();
    }
  }

  void remove(String connection) {
    if (filters.remove(connection) != null) {
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
    return filters.values().stream()
        .anyMatch(its -> its.values().stream().anyMatch(published::match));
  }
}
