package org.u2sa.service.inbox;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.schema.U2SAData;

/**
 * The newest answers to orders: a broker may deliver an order twice (QoS 1), and a sender may
 * repeat it. The repeat is answered again but not executed again. Another order with the same ID,
 * as by a program that uses one ID for all, is no repeat. Not thread-safe.
 *
 * @param <A> class of the answers
 */
public final class AnsweredOrders<A extends U2SAData> {
  private static final int REMEMBERED = 64;

  /**
   * @param content fingerprint of the order; the order itself may be long
   */
  private record Answered<A>(long content, A answer) {}

  private final Map<String, Answered<A>> answers =
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Answered<A>> eldest) {
          return size() > REMEMBERED;
        }
      };

  /** Copy of the answer to an order; empty if it was not answered yet, or has no ID. */
  @SuppressWarnings("unchecked") // a copy has the class of its original
  public Optional<A> to(String requestId, U2SAData order) {
    return Optional.ofNullable(answers.get(requestId))
        .filter(answered -> answered.content() == content(order))
        .map(answered -> (A) answered.answer().copy());
  }

  /** Remembers an answer; orders without an ID cannot be told apart. */
  @SuppressWarnings("unchecked")
  public void remember(String requestId, U2SAData order, A answer) {
    if (!requestId.isEmpty()) {
      answers.put(requestId, new Answered<>(content(order), (A) answer.copy()));
    }
  }

  /**
   * Length and hash of an order without its timestamp, because a sender may stamp a repeat again.
   */
  private static long content(U2SAData order) {
    U2SAData copy = order.copy();
    copy.timestamp(0L);
    copy.freeze();
    byte[] bytes = copy.serialize();
    return (long) bytes.length << Integer.SIZE | Integer.toUnsignedLong(Arrays.hashCode(bytes));
  }
}
