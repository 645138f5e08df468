package org.u2sa.service.inbox;

import java.util.ArrayList;
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

  private final Map<String, A> answers = // by identity of the order
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, A> eldest) {
          return size() > REMEMBERED;
        }
      };

  /** What a repeat has in common with its order; empty if it has neither ID nor timestamp. */
  public static Optional<String> identity(String requestId, U2SAData order) {
    return OrderIdentity.of(requestId, order);
  }

  /** Copy of the answer to an order; empty if it was not answered yet, or cannot be recognised. */
  @SuppressWarnings("unchecked") // a copy has the class of its original
  public Optional<A> to(String requestId, U2SAData order) {
    return identity(requestId, order).map(answers::get).map(answer -> (A) answer.copy());
  }

  /** Remembers an answer; orders without ID and timestamp cannot be told apart. */
  @SuppressWarnings("unchecked")
  public void remember(String requestId, U2SAData order, A answer) {
    identity(requestId, order).ifPresent(identity -> answers.put(identity, (A) answer.copy()));
  }

  /** For a successor. */
  public void handOver(HandOver state, String name) {
    state.texts(name, answers.keySet());
    state.messages(name + " ANSWERS", new ArrayList<>(answers.values()));
  }

  /** Remembers what a predecessor answered. */
  public void takeOver(HandOver state, String name, Class<A> type) {
    List<String> identities = state.texts(name);
    List<A> values = state.messages(name + " ANSWERS", type);
    for (int i = 0; i < Math.min(identities.size(), values.size()); i++) {
      answers.put(identities.get(i), values.get(i));
    }
  }
}
