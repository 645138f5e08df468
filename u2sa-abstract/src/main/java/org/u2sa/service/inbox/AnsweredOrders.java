package org.u2sa.service.inbox;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/**
 * The newest answers to orders: a broker may deliver an order twice (QoS 1). The repeat is answered
 * again but not executed again. Another order with the same ID, as by a program that uses one ID
 * for all, is no repeat, nor is the same order with another timestamp: it was given again. Not
 * thread-safe.
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

  /** For a successor. */
  public void handOver(HandOver state, String name) {
    List<String> keys = new ArrayList<>();
    List<A> values = new ArrayList<>();
    answers.forEach(
        (id, answered) -> {
          keys.add(answered.content() + " " + id);
          values.add(answered.answer());
        });
    state.texts(name, keys).messages(name + " ANSWERS", values);
  }

  /** Remembers what a predecessor answered. */
  public void takeOver(HandOver state, String name, Class<A> type) {
    List<String> keys = state.texts(name);
    List<A> values = state.messages(name + " ANSWERS", type);
    for (int i = 0; i < Math.min(keys.size(), values.size()); i++) {
      int end = keys.get(i).indexOf(' ');
      long content = Long.parseLong(keys.get(i).substring(0, end));
      answers.put(keys.get(i).substring(end + 1), new Answered<>(content, values.get(i)));
    }
  }

  /** Length and hash of an order. */
  private static long content(U2SAData order) {
    byte[] bytes = order.serialize();
    return (long) bytes.length << Integer.SIZE | Integer.toUnsignedLong(Arrays.hashCode(bytes));
  }
}
