package org.u2sa.core.communication.access;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.u2sa.interfaces.OneLine;

/**
 * Counts what the broker refuses or drops, and logs the 1st, 2nd, 4th, 8th … of each kind, so that
 * a flood does not fill the log. Thread-safe.
 */
public final class Refusals {
  private static final int KINDS_AT_MOST = 512;
  private static final int LONGEST_NAME = 120;

  private final Consumer<String> log;
  private final AtomicLong total = new AtomicLong();
  private final Map<String, AtomicLong> byKind = new ConcurrentHashMap<>();

  /**
   * @param log receives the lines
   */
  public Refusals(Consumer<String> log) {
    this.log = log;
  }

  /**
   * @param kind the counter; never text from a client
   * @param details client, address and object; may contain text from a client
   */
  public void add(String kind, String details) {
    total.incrementAndGet();
    String key = byKind.size() < KINDS_AT_MOST || byKind.containsKey(kind) ? kind : "others";
    long count = byKind.computeIfAbsent(key, name -> new AtomicLong()).incrementAndGet();
    if (Long.bitCount(count) == 1) {
      log.accept(kind + ": " + details + " (" + count + " so far)");
    }
  }

  /** Total count. */
  public long total() {
    return total.get();
  }

  /** Count of one kind. */
  public long of(String kind) {
    AtomicLong count = byKind.get(kind);
    return count == null ? 0 : count.get();
  }

  /** A client's text, sanitised for a log line. */
  public static String shown(String text) {
    String cut = text.length() > LONGEST_NAME ? text.substring(0, LONGEST_NAME) + "…" : text;
    return "\"" + OneLine.of(cut) + "\"";
  }
}
