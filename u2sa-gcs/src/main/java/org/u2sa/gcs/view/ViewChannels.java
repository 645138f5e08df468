package org.u2sa.gcs.view;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** All announced channels by topic, and the last message of latched ones. */
final class ViewChannels {
  /** The last message of a channel, with its time [ns]. */
  record Last(long nanos, byte[] data) {}

  private static final long MAX_KEPT_BYTES = 64L << 20;

  private final long maxKeptBytes;
  private long keptBytes; // guarded by this
  private final Map<String, ViewChannel> byTopic = new LinkedHashMap<>(); // guarded by this
  private final Map<Integer, ViewChannel> byId = new LinkedHashMap<>(); // guarded by this
  private final Map<Integer, Last> last = new LinkedHashMap<>(); // oldest first; guarded by this

  ViewChannels() {
    this(MAX_KEPT_BYTES);
  }

  /**
   * @param maxKeptBytes limit of the messages kept for late viewers [B]; beyond it, the oldest are
   *     dropped
   */
  ViewChannels(long maxKeptBytes) {
    this.maxKeptBytes = maxKeptBytes;
  }

  synchronized Optional<ViewChannel> of(String topic) {
    return Optional.ofNullable(byTopic.get(topic));
  }

  synchronized boolean has(long id) {
    return id == (int) id && byId.containsKey((int) id);
  }

  synchronized ViewChannel add(
      String topic, String encoding, String schemaName, byte[] schema, boolean latched) {
    ViewChannel channel =
        new ViewChannel(byTopic.size() + 1, topic, encoding, schemaName, schema, latched);
    byTopic.put(topic, channel);
    byId.put(channel.id(), channel);
    return channel;
  }

  synchronized int size() {
    return byTopic.size();
  }

  synchronized List<ViewChannel> all() {
    return new ArrayList<>(byTopic.values());
  }

  synchronized void keep(ViewChannel channel, long nanos, byte[] data) {
    Last before = last.remove(channel.id());
    keptBytes += data.length - (before == null ? 0 : before.data.length);
    last.put(channel.id(), new Last(nanos, data));
    Iterator<Last> oldest = last.values().iterator();
    while (keptBytes > maxKeptBytes) {
      keptBytes -= oldest.next().data.length;
      oldest.remove();
    }
  }

  synchronized Optional<Last> last(int id) {
    return Optional.ofNullable(last.get(id));
  }
}
