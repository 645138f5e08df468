package org.u2sa.core.communication;

import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import org.u2sa.core.communication.limit.BrokerLimits;

/**
 * Limits one kind of memory that the broker holds for its connections, such as incomplete packets.
 * Beyond the total limit, closes the largest connection of the user who uses the most memory, so
 * that nobody can exhaust it. Not thread-safe.
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
   * @param maxBytes limit of all connections together [B]
   * @param end closes a connection; called once for each
   */
  MemoryBudget(long maxBytes, Function<C, String> userOf, Consumer<C> end) {
    this.maxBytes = maxBytes;
    this.userOf = userOf;
    this.end = end;
  }

  /**
   * Creates a budget for clients.
   *
   * @param part divisor of the heap size, such as 8 for an eighth; direct memory has the same size
   *     by default
   * @param maxBytes upper limit for any heap size [B]
   * @param why reason for the log
   */
  static MemoryBudget<Client> ofClients(int part, long maxBytes, String why) {
    long fitting = Math.min(maxBytes, Runtime.getRuntime().maxMemory() / part);
    return new MemoryBudget<>(
        Math.max(fitting, BrokerLimits.LONGEST_PACKET),
        Client::name,
        client -> client.putOutFor(why));
  }

  /** Sets the bytes held for a connection; 0 for none. */
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
