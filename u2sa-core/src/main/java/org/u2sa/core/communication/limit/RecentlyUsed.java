package org.u2sa.core.communication.limit;

import java.util.LinkedHashMap;
import java.util.Map;

/** A bounded map that evicts the least recently used entry (LRU). Not thread-safe. */
public final class RecentlyUsed<V> extends LinkedHashMap<String, V> {
  private static final long serialVersionUID = 1L;

  private final int most;

  /**
   * @param most maximum number of entries
   */
  public RecentlyUsed(int most) {
    super(16, 0.75f, true);
    this.most = most;
  }

  @Override
  protected boolean removeEldestEntry(Map.Entry<String, V> eldest) {
    return size() > most;
  }
}
