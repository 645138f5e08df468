package org.u2sa.gcs.mavlink.vehicle;

import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.U2SAData;

/**
 * An order without an answer so far. The broker forwards it to the bridge too; if it forwards a
 * later question but not the order, it has refused the order. Confined to the bridge's thread,
 * except for {@link #take}.
 */
final class OrderUnderWay {
  private static final long ANSWER_WITHIN_MICROS = 3_000_000;
  private static final long PERSIST_MICROS = 30_000_000;
  private static final long AGAIN_AFTER_MICROS = 500_000;

  private final OrdersUnderWay.Order order;
  private final long sinceMicros;
  private long againMicros;
  private String failure = ""; // of the last attempt to publish it
  private volatile DiscoveryRequest question; // published right after the order; null before
  private volatile boolean isForwarded; // or cleared since
  private volatile boolean isRefused;

  OrderUnderWay(OrdersUnderWay.Order order, long nowMicros) {
    this.order = order;
    sinceMicros = nowMicros;
    againMicros = nowMicros + AGAIN_AFTER_MICROS;
  }

  OrdersUnderWay.Order order() {
    return order;
  }

  long sinceMicros() {
    return sinceMicros;
  }

  /**
   * Publishes the order.
   *
   * @throws CommunicationException if it was not accepted
   */
  void publish(OrdersUnderWay.Publisher publisher) {
    try {
      publisher.publish(order.channel(), order.message());
      failure = "";
    } catch (CommunicationException e) {
      failure = e.getMessage();
      throw e;
    }
  }

  /** Whether to tell the station that the order is in progress, and perhaps to publish it again. */
  boolean isDue(long nowMicros) {
    boolean isDue = nowMicros >= againMicros;
    if (isDue) {
      againMicros = nowMicros + AGAIN_AFTER_MICROS;
    }
    return isDue;
  }

  /** Whether the broker has not forwarded it yet, as far as known. */
  boolean isToRepeat() {
    return !isForwarded && (order.kind() == OrdersUnderWay.Kind.STOP || !failure.isEmpty());
  }

  /** Whether a question would show that the broker has refused it, if published right after it. */
  boolean isToAsk(long nowMicros) {
    return !isForwarded && question == null && nowMicros - sinceMicros >= ANSWER_WITHIN_MICROS;
  }

  /** Publishes the order and such a question. */
  void ask(OrdersUnderWay.Publisher publisher) {
    publish(publisher);
    DiscoveryRequest asked = new DiscoveryRequest();
    publisher.publish(Channels.DISCOVERY, asked);
    question = asked;
  }

  /** Takes a message that the broker has forwarded; on any thread. */
  void take(U2SAData message) {
    if (message instanceof DiscoveryRequest heard) {
      isRefused = isRefused || !isForwarded && isSame(question, heard);
    } else if (message instanceof ArmCommand || message instanceof EmergencyStop) {
      isForwarded = isForwarded || isSame(order.message(), message) || isObsolete(message);
    }
  }

  /** Whether the broker has sent back what was published, by its time: RemoteLink sets it. */
  private static boolean isSame(U2SAData published, U2SAData heard) {
    return published != null
        && published.type().equals(heard.type())
        && published.timestamp().isPresent()
        && published.timestamp().equals(heard.timestamp());
  }

  /** Whether the same stop was given again later, or an operator has cleared it since. */
  private boolean isObsolete(U2SAData message) {
    if (order.message() instanceof EmergencyStop own && message instanceof EmergencyStop other) {
      long untilMicros =
          !other.active()
              ? other.clears().orElse(Long.MIN_VALUE)
              : own.identity().equals(other.identity())
                  ? other.timestamp().orElse(Long.MIN_VALUE)
                  : Long.MIN_VALUE;
      return untilMicros >= own.timestamp().orElse(Long.MAX_VALUE);
    }
    return false;
  }

  boolean isRefused() {
    return isRefused;
  }

  boolean isOver(long nowMicros) {
    return nowMicros - sinceMicros
        > (order.kind().isPersistent() ? PERSIST_MICROS : ANSWER_WITHIN_MICROS);
  }

  String whyOver() {
    if (!failure.isEmpty()) {
      return failure;
    }
    if (isForwarded) {
      return "no service of the vehicle has confirmed it; it may still be carried out";
    }
    return "no answer from the vehicle: the bridge's user may lack the role operator, or no"
        + " service there handles it";
  }
}
