package org.u2sa.core.communication;

import io.moquette.broker.subscriptions.Topic;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The last message of each topic that retains it, and whose it is. Bounded by number and bytes, of
 * one client and of all; what is urgent, such as an emergency stop, has room of its own, which
 * nobody else can take. Safe for several threads.
 */
final class RetainedTable {
  /** Its owner: services of this process, whose own these limits are not. */
  static final String LOCAL = "";

  private static final int HEAP_PART = 4; // of a small heap at most
  private static final int URGENT_TOPICS = 256; // three of each of many systems
  private static final int URGENT_BYTES = 16 * 1_024; // of one message

  /** A message that is retained. */
  record Retained(String topic, byte[] payload) {}

  private record Entry(String owner, byte[] payload, boolean urgent, Topic topic) {}

  private static final class Sum {
    private int topics;
    private long bytes;
  }

  private final int topicsAtMost;
  private final long bytesAtMost;
  private final long bytesOfOneAtMost;
  private final Map<String, Entry> entries = new ConcurrentHashMap<>(); // written under this
  private final Map<String, Sum> byOwner = new HashMap<>(); // guarded by this, as what follows
  private final Sum ordinary = new Sum();
  private final Sum urgent = new Sum();

  RetainedTable(BrokerLimits limits) {
    topicsAtMost = limits.retainedTopicsAtMost();
    bytesAtMost =
        Math.min(limits.retainedBytesAtMost(), Runtime.getRuntime().maxMemory() / HEAP_PART);
    bytesOfOneAtMost = limits.clientRetainedBytesAtMost();
  }

  /**
   * Retains a message, or with an empty one deletes what was retained.
   *
   * @param owner the client's user, or the client where there are no users
   * @param payload not to be changed any more
   * @return why it may not be retained; empty if it was
   */
  synchronized Optional<String> enter(
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
  synchronized void enterLocal(String topic, byte[] payload) {
    Entry before = entries.get(topic);
    entries.put(topic, entry(topic, LOCAL, payload, false, before));
    if (before != null) {
      count(before, -1);
    }
  }

  /** What is retained on the topics that a filter matches. */
  List<Retained> matching(Topic filter) {
    List<Retained> matching = new ArrayList<>();
    entries.forEach(
        (topic, entry) -> {
          if (entry.topic.match(filter)) {
            matching.add(new Retained(topic, entry.payload));
          }
        });
    return matching;
  }

  /** The topics; may change while they are looked at. */
  Set<String> topics() {
    return entries.keySet();
  }
}
