package org.u2sa.core.communication;

import io.moquette.broker.subscriptions.Topic;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiPredicate;

/**
 * The subscriptions of remote clients, by connection, so that nothing is encoded without a
 * subscriber. A filter is entered before Moquette sees it: when its client has the answer, it
 * misses nothing any more. A change is compared with the topics on the thread of the client that
 * changed it, so that no number of filters costs the services' threads anything. Safe for several
 * threads.
 */
final class RemoteSubscriptions {
  private static final int TOPICS_REMEMBERED = 4_096;

  private record Client(String user, Set<String> filters) {}

  private static final class Filter {
    private final Topic parsed;
    private int clients;

    Filter(Topic parsed) {
      this.parsed = parsed;
    }
  }

  /** A topic, and how many filters it matches. */
  private static final class Wish {
    private final Topic topic;
    private volatile int filters; // written under the lock of all

    Wish(Topic topic, int filters) {
      this.topic = topic;
      this.filters = filters;
    }
  }

  private final BiPredicate<Topic, Topic> matches;
  private final Map<String, Client> clients = new HashMap<>(); // by connection; guarded by this
  private final Map<String, Integer> byUser = new HashMap<>(); // filters; guarded by this
  private final Map<String, Filter> filters = new HashMap<>(); // each once; guarded by this
  private final Map<String, Wish> wishes = new ConcurrentHashMap<>(); // by topic
  private final AtomicInteger version = new AtomicInteger();

  RemoteSubscriptions() {
    this(Topic::match);
  }

  /**
   * @param matches whether a topic, the first, matches a filter
   */
  RemoteSubscriptions(BiPredicate<Topic, Topic> matches) {
    this.matches = matches;
  }

  /** Enters a filter; one that is none is left to Moquette to refuse. */
  synchronized void add(String connection, String user, String filter) {
    Topic parsed = new Topic(filter);
    if (!parsed.isValid()
        || !clients
            .computeIfAbsent(connection, id -> new Client(user, new HashSet<>()))
            .filters
            .add(filter)) {
      return;
    }
    byUser.merge(user, 1, Integer::sum);
    Filter entry = filters.computeIfAbsent(filter, text -> new Filter(parsed));
    entry.clients++;
    if (entry.clients == 1) {
      count(parsed, 1);
    }
  }

  synchronized void remove(String connection, String filter) {
    Client client = clients.get(connection);
    if (client != null && client.filters.remove(filter)) {
      removed(client.user, filter);
    }
  }

  synchronized void remove(String connection) {
    Client client = clients.remove(connection);
    if (client != null) {
      client.filters.forEach(filter -> removed(client.user, filter));
    }
  }

  private void removed(String user, String filter) {
    byUser.computeIfPresent(user, (name, count) -> count > 1 ? count - 1 : null);
    Filter entry = filters.get(filter);
    entry.clients--;
    if (entry.clients == 0) {
      filters.remove(filter);
      count(entry.parsed, -1);
    }
  }

  private void count(Topic filter, int change) {
    for (Wish wish : wishes.values()) {
      if (matches.test(wish.topic, filter)) {
        wish.filters += change;
      }
    }
    version.incrementAndGet();
  }

  /** How many filters a user has, by all connections. */
  synchronized int ofUser(String user) {
    return byUser.getOrDefault(user, 0);
  }

  /** Changes with every change, so that answers of {@link #wants} may be remembered. */
  int version() {
    return version.get();
  }

  /** Whether any client listens to the topic. */
  boolean wants(String topic) {
    Wish known = wishes.get(topic);
    return known != null ? known.filters > 0 : wantsNew(topic);
  }

  private synchronized boolean wantsNew(String topic) {
    Topic published = new Topic(topic);
    int count =
        (int)
            filters.values().stream()
                .filter(filter -> matches.test(published, filter.parsed))
                .count();
    if (wishes.size() < TOPICS_REMEMBERED) {
      wishes.put(topic, new Wish(published, count));
    }
    return count > 0;
  }
}
