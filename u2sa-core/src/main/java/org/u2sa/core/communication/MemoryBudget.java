package org.u2sa.core.communication;

import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * Bytes of one kind that the broker keeps for its connections, such as those of packets that are
 * not complete. Beyond a limit for all together, the connection with the most of the user with the
 * most is ended, so that nobody fills the memory. For one thread.
 *
 * @param <C> a connection
 */
final class MemoryBudget<C> {
  private final long maxBytes;
  private final Function<C, String> userOf;
  private final Consumer<C> end;
  private final Map<C, Long> bytes = new HashMap<>();
  private long total;

  /**
   * @param maxBytes of all connections
   * @param end ends a connection; called once for each
   */
  MemoryBudget(long maxBytes, Function<C, String> userOf, Consumer<C> end) {
    this.maxBytes = maxBytes;
    this.userOf = userOf;
    this.end = end;
  }

  /**
   * A budget of clients.
   *
   * @param part which part of the heap's size it is, such as 8 for an eighth; direct memory has
   *     that size too, unless Java was told otherwise
   * @param maxBytes at most, whatever the heap's size
   * @param why for the log
   */
  static MemoryBudget<ClientSession> ofClients(int part, long maxBytes, String why) {
    long fitting = Math.min(maxBytes, Runtime.getRuntime().maxMemory() / part);
    return new MemoryBudget<>(
        Math.max(fitting, BrokerLimits.LONGEST_PACKET),
        ClientSession::name,
        client -> client.putOutFor(why));
  }

  /** Sets how many bytes are kept for one connection; 0: none. */
  void set(C connection, long length) {
    Long before = length == 0 ? bytes.remove(connection) : bytes.put(connection, length);
    total += length - (before == null ? 0 : before);
    if (total > maxBytes) {
      C worst = worst();
      total -= bytes.remove(worst);
      end.accept(worst);
    }
  }

  private C worst() {
    Map<String, Long> byUser = new HashMap<>();
    bytes.forEach((one, count) -> byUser.merge(userOf.apply(one), count, Long::sum));
    return bytes.entrySet().stream()
        .max(
            Comparator.<Map.Entry<C, Long>>comparingLong(
                    entry -> byUser.get(userOf.apply(entry.getKey())))
                .thenComparingLong(Map.Entry::getValue))
        .orElseThrow()
        .getKey();
  }
}
