package org.u2sa.service;

import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.inbox.ServiceInbox;

/**
 * Dispatches messages from the transport: stop orders are obeyed immediately, other messages for
 * the service are queued in its inbox. Called on the transport's or another service's thread, so it
 * never blocks.
 *
 * <p>Belongs to the connection rather than to the service: in a swap, messages go to the successor
 * from one message to the next.
 */
final class ServiceReceiver implements Receiver {
  /**
   * The services served.
   *
   * @param next prospective successor, which gets the messages that the present service has not
   *     subscribed to; null if none
   */
  private record Served(U2SAService present, U2SAService next) {}

  private final AtomicLong misplaced = new AtomicLong();
  private volatile Served served;

  ServiceReceiver(U2SAService service) {
    served = new Served(service, null);
  }

  /** Routes messages that only the successor subscribed to into the successor's inbox. */
  void prepare(U2SAService successor) {
    served = new Served(served.present, successor);
  }

  /** Undoes {@link #prepare}. */
  void forget() {
    served = new Served(served.present, null);
  }

  /** Routes everything to this service from now on. */
  void turnTo(U2SAService successor) {
    served = new Served(successor, null);
  }

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    Served now = served;
    if (!channel.carries(message)) {
      refuse(now.present, channel, message);
    } else if (now.present.handling.contract().isOrderToStop(channel, message)) {
      now.present.life.stopFor("told to stop on \"" + channel + "\": " + message);
    } else if (now.present.wiring.registrations().isSubscribed(channel)
        || now.present.handling.contract().concerns(channel, message)) {
      put(now.present, channel, message);
    } else if (now.next != null && now.next.wiring.registrations().isSubscribed(channel)) {
      put(now.next, channel, message);
    }
  }

  /** Rejects types on the wrong channel, because services act on the type alone. */
  private void refuse(U2SAService service, Channel<?> channel, U2SAData message) {
    long count = misplaced.incrementAndGet();
    if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: limits the log
      service.log(
          LogLevelEnum.WARN,
          String.format(
              "refused on \"%s\", which does not carry %s (%s so far): %s",
              channel, message.type().name(), count, message));
    }
  }

  private void put(U2SAService service, Channel<?> channel, U2SAData message) {
    ServiceInbox inbox = service.handling.inbox();
    boolean ages = service.wiring.registrations().deadlineMicros(channel) != Clock.NEVER;
    long arrivedMicros = ages ? service.clock().micros() : 0L; // reading the clock is slow
    ServiceInbox.Outcome outcome = inbox.put(channel, message, arrivedMicros);
    if (outcome != ServiceInbox.Outcome.KEPT && Long.bitCount(inbox.dropped()) == 1) {
      String why =
          switch (outcome) {
            case UNKNOWN_SOURCE ->
                String.format(
                    "more than %s sources on \"%s\", \"%s\" is one too many",
                    ServiceInbox.MAX_SOURCES, channel, channel.sourceOf(message));
            case TOO_LONG ->
                String.format(
                    "long messages of many sources on \"%s\", that of \"%s\" is one too many",
                    channel, channel.sourceOf(message));
            default -> "inbox full";
          };
      service.log(LogLevelEnum.WARN, why + ": " + inbox.dropped() + " messages dropped so far");
    }
    U2SAService waiting = served.present; // re-read: may have moved to a successor
    if (channel.isUrgent() || !waiting.handling.isPatient()) {
      waiting.life.wake();
    }
  }

  @Override
  public void trouble(String what) {
    served.present.log(LogLevelEnum.WARN, what);
  }
}
