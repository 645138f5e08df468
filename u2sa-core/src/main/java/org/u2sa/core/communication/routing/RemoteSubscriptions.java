package org.u2sa.core.communication.routing;

import io.moquette.broker.subscriptions.Topic;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiPredicate;
import java.util.function.Consumer;
import org.u2sa.core.communication.limit.RecentlyUsed;

/**
 * Subscriptions of remote clients by connection, so that messages without subscribers are not
 * encoded and subscribers are found quickly. Filters are matched against topics on the thread of
 * the changing client, so the number of filters does not slow the services' threads. Thread-safe.
 */
public final class RemoteSubscriptions {
  private static final int TOPICS_REMEMBERED = 4_096;

  /** One connection's filters, and whether each requires every message. */
  private record Client(String user, Map<String, Boolean> filters) {}

  /** A filter, and whether each message matters to each connection that has it. */
  private record Filter(Topic parsed, Map<String, Boolean> clients) {}

  private final BiPredicate<Topic, Topic> matches;
  private final Map<String, Client> clients = new HashMap<>(); // by connection; guarded by this
  private final Map<String, Integer> byUser = new HashMap<>(); // filters; guarded by this
  private final Map<String, Filter> filters = new HashMap<>(); // distinct filters; guarded by this
  private final Map<String, TopicRoute> interests = new ConcurrentHashMap<>(); // cached topics
  private final Map<String, TopicRoute> routes = // by topic; guarded by this
      new RecentlyUsed<>(TOPICS_REMEMBERED);
  private final AtomicInteger version = new AtomicInteger();

  /** No subscriptions yet. */
  public RemoteSubscriptions() {
    this(Topic::match);
  }

  /**
   * @param matches whether a topic (first argument) matches a filter
   */
  public RemoteSubscriptions(BiPredicate<Topic, Topic> matches) {
    this.matches = matches;
  }

  /**
   * Adds a filter, or changes the QoS of an existing one.
   *
   * @param filter a {@link TopicFilter#isValid valid} one
   * @param eachMatters whether the client asks for QoS 1 or more
   */
  public synchronized void add(String connection, String user, String filter, boolean eachMatters) {
    Topic parsed = new Topic(filter);
    Client client =
        clients.computeIfAbsent(connection, id -> new Client(user, new LinkedHashMap<>()));
    Boolean before = client.filters.get(filter);
    if (before != null && before == eachMatters) {
      return;
    }
    if (before != null) {
      remove(connection, filter);
    }
    client.filters.put(filter, eachMatters);
    byUser.merge(user, 1, Integer::sum);
    filters
        .computeIfAbsent(filter, text -> new Filter(parsed, new LinkedHashMap<>()))
        .clients
        .put(connection, eachMatters);
    matching(parsed, route -> route.add(connection, eachMatters));
    version.incrementAndGet();
  }

  /** Removes one subscription of a connection. */
  public synchronized void remove(String connection, String filter) {
    Client client = clients.get(connection);
    if (client != null && client.filters.containsKey(filter)) {
      removed(connection, client, filter, client.filters.remove(filter));
    }
  }

  /** Removes all filters of a connection without matching any topics. */
  public synchronized void remove(String connection) {
    Client client = clients.remove(connection);
    if (client != null) {
      client.filters.keySet().forEach(filter -> entryWithout(connection, client, filter));
      routes.values().forEach(route -> route.remove(connection));
      interests.values().forEach(route -> route.remove(connection));
      version.incrementAndGet();
    }
  }

  private Filter entryWithout(String connection, Client client, String filter) {
    byUser.computeIfPresent(client.user, (name, count) -> count > 1 ? count - 1 : null);
    Filter entry = filters.get(filter);
    entry.clients.remove(connection);
    if (entry.clients.isEmpty()) {
      filters.remove(filter);
    }
    return entry;
  }

  private void removed(String connection, Client client, String filter, boolean eachMatters) {
    Filter entry = entryWithout(connection, client, filter);
    matching(entry.parsed, route -> route.remove(connection, eachMatters));
    version.incrementAndGet();
  }

  /** Number of filters of a user over all connections. */
  public synchronized int ofUser(String user) {
    return byUser.getOrDefault(user, 0);
  }

  /**
   * Version number that changes with every modification, so that results of {@link #wants} can be
   * cached.
   */
  public int version() {
    return version.get();
  }

  private void matching(Topic filter, Consumer<TopicRoute> change) {
    for (Collection<TopicRoute> all : List.of(routes.values(), interests.values())) {
      for (TopicRoute route : all) {
        if (matches.test(route.topic(), filter)) {
          change.accept(route);
        }
      }
    }
  }

  /** Number of topics each new filter is matched against. */
  public synchronized int topics() {
    return routes.size() + interests.size();
  }

  /** Number of filters each new topic is matched against. */
  public synchronized int filters() {
    return filters.size();
  }

  /**
   * Whether any client subscribes to the topic. The result is cached from then on; use it only for
   * topics of this process, whose number no client controls.
   */
  public boolean wants(String topic) {
    TopicRoute known = interests.get(topic);
    return known != null ? known.isWanted() : newInterest(topic).isWanted();
  }

  private synchronized TopicRoute newInterest(String topic) {
    return interests.computeIfAbsent(topic, this::newRoute);
  }

  /** Whether the topic is cached, so that {@link #route} need not match any filter. */
  public synchronized boolean isRemembered(String topic) {
    return routes.containsKey(topic);
  }

  /**
   * The subscribers of a topic. Least recently used topics are evicted and matched again on demand.
   */
  public synchronized TopicRoute route(String topic) {
    TopicRoute known = routes.get(topic);
    if (known == null) {
      known = newRoute(topic);
      routes.put(topic, known);
    }
    return known;
  }

  private TopicRoute newRoute(String topic) {
    TopicRoute route = new TopicRoute(topic);
    for (Filter filter : filters.values()) {
      if (matches.test(route.topic(), filter.parsed)) {
        filter.clients.forEach(route::add);
      }
    }
    return route;
  }
}
