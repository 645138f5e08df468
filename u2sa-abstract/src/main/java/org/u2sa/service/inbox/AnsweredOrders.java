package org.u2sa.service.inbox;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.schema.U2SAData;

/**
 * The newest answers to orders: a broker may deliver an order twice (QoS 1), and the repeat is
 * answered again but not executed again. Not thread-safe.
 *
 * @param <A> class of the answers
 */
public final class AnsweredOrders<A extends U2SAData> {
  private static final int REMEMBERED = 64;

  private final Map<String, A> answers =
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, A> eldest) {
          return size() > REMEMBERED;
        }
      };

  /** Copy of the answer to an order; empty if it was not answered yet, or has no ID. */
  @SuppressWarnings("unchecked") // a copy has the class of its original
  public Optional<A> to(String requestId) {
    return Optional.ofNullable(answers.get(requestId)).map(answer -> (A) answer.copy());
  }

  /** Remembers an answer; orders without an ID cannot be told apart. */
  @SuppressWarnings("unchecked")
  public void remember(String requestId, A answer) {
    if (!requestId.isEmpty()) {
      answers.put(requestId, (A) answer.copy());
    }
  }
}
