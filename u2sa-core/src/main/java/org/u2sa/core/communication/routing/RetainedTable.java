package org.u2sa.core.communication.routing;

import io.moquette.broker.subscriptions.Topic;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.u2sa.core.communication.limit.BrokerLimits;

/**
 * Retained messages by topic, with their owners. Bounded in number and bytes, per client and in
 * total; urgent messages, such as an emergency stop, have reserved room. Thread-safe.
 */
public final class RetainedTable {
  /** Owner for services of this process, which are exempt from the limits. */
  static final String LOCAL = "";

  private static final int HEAP_PART = 4; // at most this fraction of a small heap
  private static final int URGENT_TOPICS = 256; // three each for many systems
  private static final int URGENT_BYTES = 16 * 1_024; // per message

  /** A retained message. */
  public record Retained(String topic, byte[] payload) {}

  private record Entry(String owner, byte[] payload, boolean urgent, Topic topic) {}

  private static final class Sum {
    private int topics;
    private long bytes;
  }

  private final int topicsAtMost;
  private final long bytesAtMost;
  private final long bytesOfOneAtMost;
  private final Map<String, Entry> entries = new ConcurrentHashMap<>(); // written under this
  private final Map<String, Sum> byOwner = new HashMap<>(); // guarded by this, like those below
  private final Sum ordinary = new Sum();
  private final Sum urgent = new Sum();

  /** An empty table with these limits. */
  public RetainedTable(BrokerLimits limits) {
    topicsAtMost = limits.maxRetainedTopics();
    bytesAtMost = Math.min(limits.maxRetainedBytes(), Runtime.getRuntime().maxMemory() / HEAP_PART);
    bytesOfOneAtMost = limits.maxClientRetainedBytes();
  }

  /**
   * Retains a message; an empty one deletes the retained message.
   *
   * @param owner the client's user, or the client if there are no users
   * @param payload must not be modified afterwards
   * @return the reason for refusing, or empty
   */
  public synchronized Optional<String> enter(
      String topic, String owner, byte[] payload, boolean isUrgent) {
    Entry before = entries.get(topic);
    if (before != null) {
      count(before, -1);
    }
    Entry entry = entry(topic, owner, payload, isUrgent, before);
    Optional<String> refusal = payload.length == 0 ? Optional.empty() : refusal(entry);
    Entry stays = refusal.isPresent() ? before : entry;
    if (stays == null || stays.payload.length == 0) {
      entries.remove(topic);
    } else {
      entries.put(topic, stays);
      count(stays, 1);
    }
    return refusal;
  }

  private static Entry entry(
      String topic, String owner, byte[] payload, boolean isUrgent, Entry before) {
    return new Entry(owner, payload, isUrgent, before == null ? new Topic(topic) : before.topic);
  }

  private Optional<String> refusal(Entry entry) {
    if (entry.urgent) {
      return entry.payload.length > URGENT_BYTES || urgent.topics >= URGENT_TOPICS
          ? Optional.of("too much urgent is retained")
          : Optional.empty();
    }
    Sum own = byOwner.getOrDefault(entry.owner, new Sum());
    if (ordinary.topics >= topicsAtMost) {
      return Optional.of("too many retained topics");
    }
    if (own.topics >= Math.max(1, topicsAtMost / 2)) {
      return Optional.of("too many retained topics of one client");
    }
    if (own.bytes + entry.payload.length > bytesOfOneAtMost) {
      return Optional.of("too many retained bytes of one client");
    }
    return ordinary.bytes + entry.payload.length > bytesAtMost
        ? Optional.of("too many retained bytes")
        : Optional.empty();
  }

  private void count(Entry entry, int sign) {
    if (entry.owner.equals(LOCAL)) {
      return;
    }
    count(entry.urgent ? urgent : ordinary, entry, sign);
    Sum own = byOwner.computeIfAbsent(entry.owner, name -> new Sum());
    if (!entry.urgent) {
      count(own, entry, sign);
    }
    if (own.topics == 0) {
      byOwner.remove(entry.owner);
    }
  }

  private static void count(Sum sum, Entry entry, int sign) {
    sum.topics += sign;
    sum.bytes += (long) sign * entry.payload.length;
  }

  /** Retains a message of this process. */
  public synchronized void enterLocal(String topic, byte[] payload) {
    Entry before = entries.get(topic);
    entries.put(topic, entry(topic, LOCAL, payload, false, before));
    if (before != null) {
      count(before, -1);
    }
  }

  /** The retained messages on topics that match a filter. */
  public List<Retained> matching(Topic filter) {
    List<Retained> matching = new ArrayList<>();
    entries.forEach(
        (topic, entry) -> {
          if (entry.topic.match(filter)) {
            matching.add(new Retained(topic, entry.payload));
          }
        });
    return matching;
  }

  /** The topics; weakly consistent. */
  public Set<String> topics() {
    return entries.keySet();
  }
}
