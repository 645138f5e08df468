package org.u2sa.core.communication;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Of which topics the broker holds a message, how long it is and whose it is. Bounded by number and
 * bytes, of one client and of all; what is urgent, such as an emergency stop, has room of its own,
 * which nobody else can take. Safe for several threads.
 */
final class RetainedTable {
  /** Its owner: services of this process, whose own these limits are not. */
  static final String LOCAL = "";

  private static final int URGENT_TOPICS = 256; // three of each of many systems
  private static final int URGENT_BYTES = 16 * 1_024; // of one message

  private record Entry(String owner, int bytes, boolean urgent) {}

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
    bytesAtMost = limits.retainedBytesAtMost();
    bytesOfOneAtMost = limits.clientRetainedBytesAtMost();
  }

  /**
   * Enters a message that is about to be retained; of no length, one that is deleted.
   *
   * @param owner the client's user, or the client where there are no users
   * @return why it may not be; empty if it was entered
   */
  synchronized Optional<String> enter(String topic, String owner, int bytes, boolean isUrgent) {
    Entry before = entries.get(topic);
    if (before != null) {
      count(before, -1);
    }
    Entry entry = new Entry(owner, bytes, isUrgent);
    Optional<String> refusal = bytes == 0 ? Optional.empty() : refusal(entry);
    Entry stays = refusal.isPresent() ? before : entry;
    if (stays == null || stays.bytes == 0) {
      entries.remove(topic);
    } else {
      entries.put(topic, stays);
      count(stays, 1);
    }
    return refusal;
  }

  private Optional<String> refusal(Entry entry) {
    if (entry.urgent) {
      return entry.bytes > URGENT_BYTES || urgent.topics >= URGENT_TOPICS
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
    if (own.bytes + entry.bytes > bytesOfOneAtMost) {
      return Optional.of("too many retained bytes of one client");
    }
    return ordinary.bytes + entry.bytes > bytesAtMost
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
    sum.bytes += (long) sign * entry.bytes;
  }

  /** Enters a message of this process. */
  synchronized void enterLocal(String topic, int bytes) {
    Entry before = entries.put(topic, new Entry(LOCAL, bytes, false));
    if (before != null) {
      count(before, -1);
    }
  }

  /** The topics; may change while they are looked at. */
  Set<String> topics() {
    return entries.keySet();
  }
}
