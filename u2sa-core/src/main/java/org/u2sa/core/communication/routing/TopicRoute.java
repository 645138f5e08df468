package org.u2sa.core.communication.routing;

import io.moquette.broker.subscriptions.Topic;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A topic and its subscribed connections. Thread-safe. */
public final class TopicRoute {
  /**
   * A subscribed connection.
   *
   * @param eachMatters whether any of its filters has QoS 1 or 2
   */
  public record Listener(String connection, boolean eachMatters) {}

  /** Number of matching filters of one connection. */
  private static final class Count {
    private int all;
    private int eachMatters;
  }

  private final String name;
  private final Topic topic;
  private final byte[] utf8;
  private final Map<String, Count> counts = new LinkedHashMap<>(); // by connection; guarded by this
  private volatile boolean wanted;
  private volatile List<Listener> listeners = List.of(); // null: to be rebuilt

  /** Splits a topic name into its levels. */
  public TopicRoute(String name) {
    this.name = name;
    topic = new Topic(name);
    utf8 = name.getBytes(StandardCharsets.UTF_8);
  }

  String name() {
    return name;
  }

  /** Parsed topic, for matching filters. */
  Topic topic() {
    return topic;
  }

  /** Topic as encoded in a packet; must not be modified. */
  byte[] utf8() {
    return utf8;
  }

  /** Whether there are subscribers. */
  public boolean isWanted() {
    return wanted;
  }

  /** Subscribers, each connection once. */
  public List<Listener> listeners() {
    List<Listener> known = listeners;
    return known != null ? known : listed();
  }

  private synchronized List<Listener> listed() {
    List<Listener> all = new ArrayList<>(counts.size());
    counts.forEach((connection, count) -> all.add(new Listener(connection, count.eachMatters > 0)));
    listeners = Collections.unmodifiableList(all);
    return listeners;
  }

  /** Adds a matching filter of a connection. */
  synchronized void add(String connection, boolean eachMatters) {
    Count count = counts.computeIfAbsent(connection, id -> new Count());
    count.all++;
    count.eachMatters += eachMatters ? 1 : 0;
    wanted = true;
    listeners = null;
  }

  /** Reverts one {@link #add}. */
  synchronized void remove(String connection, boolean eachMatters) {
    Count count = counts.get(connection);
    count.all--;
    count.eachMatters -= eachMatters ? 1 : 0;
    if (count.all == 0) {
      counts.remove(connection);
    }
    wanted = !counts.isEmpty();
    listeners = null;
  }

  /** Reverts every {@link #add} of a connection. */
  synchronized void remove(String connection) {
    if (counts.remove(connection) != null) {
      wanted = !counts.isEmpty();
      listeners = null;
    }
  }
}
