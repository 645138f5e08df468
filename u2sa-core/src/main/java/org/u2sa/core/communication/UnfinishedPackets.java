package org.u2sa.core.communication;

import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * Bytes that wait at the broker for the rest of their packet, of all connections. Beyond a limit
 * the connection with the most of the user with the most is ended, so that nobody fills the memory
 * with packets that never end. For one thread.
 *
 * @param <C> a connection
 */
final class UnfinishedPackets<C> {
  private static final long MAX_BYTES = 64 << 20;
  private static final int HEAP_PART = 8; // direct memory has the heap's size unless told otherwise

  private final long maxBytes;
  private final Function<C, String> userOf;
  private final Consumer<C> end;
  private final Map<C, Integer> bytes = new HashMap<>();
  private long total;

  /**
   * @param maxBytes of all connections
   * @param end ends a connection; called once for each
   */
  UnfinishedPackets(long maxBytes, Function<C, String> userOf, Consumer<C> end) {
    this.maxBytes = maxBytes;
    this.userOf = userOf;
    this.end = end;
  }

  /** With a limit that fits this process's memory; the longest packet always fits. */
  static UnfinishedPackets<ClientSession> ofClients() {
    long fitting = Math.min(MAX_BYTES, Runtime.getRuntime().maxMemory() / HEAP_PART);
    return new UnfinishedPackets<>(
        Math.max(fitting, BrokerLimits.LONGEST_PACKET),
        ClientSession::name,
        client ->
            client.putOutFor("connection closed, too many bytes wait for the rest of a packet"));
  }

  /** Sets how many bytes of one connection wait; 0: none. */
  void set(C connection, int length) {
    Integer before = length == 0 ? bytes.remove(connection) : bytes.put(connection, length);
    total += length - (before == null ? 0 : before);
    if (total > maxBytes) {
      C worst = worst();
      total -= bytes.remove(worst);
      end.accept(worst);
    }
  }

  private C worst() {
    Map<String, Long> byUser = new HashMap<>();
    bytes.forEach((one, count) -> byUser.merge(userOf.apply(one), (long) count, Long::sum));
    return bytes.entrySet().stream()
        .max(
            Comparator.<Map.Entry<C, Integer>>comparingLong(
                    entry -> byUser.get(userOf.apply(entry.getKey())))
                .thenComparingInt(Map.Entry::getValue))
        .orElseThrow()
        .getKey();
  }
}
