package org.u2sa.service;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.inbox.ContractOrders;
import org.u2sa.service.inbox.ServiceInbox;

/**
 * Dispatches messages from the transport: obeys stop orders immediately, and queues other messages
 * in the inbox. Called on the transport's or another service's thread, so it never blocks.
 *
 * <p>Belongs to the connection rather than to the service: in a swap, messages go to the successor
 * from one message to the next.
 */
final class ServiceReceiver implements Receiver {
  /** A service as the dispatcher sees it. */
  record Recipient(
      ServiceConfiguration configuration,
      Registrations registrations,
      ServiceInbox inbox,
      ServiceLife life,
      ContractOrders orders) {
    private boolean isSubscribed(Channel<?> channel) {
      return registrations.isSubscribed(channel);
    }

    private void put(Channel<?> channel, U2SAData message) {
      boolean ages = registrations.deadlineMicros(channel) != Clock.NEVER;
      long arrivedMicros = ages ? configuration.clock().micros() : 0L; // reading the clock is slow
      ServiceInbox.Outcome outcome = inbox.put(channel, message, arrivedMicros);
      if (outcome != ServiceInbox.Outcome.KEPT && Long.bitCount(inbox.dropped()) == 1) {
        String why =
            switch (outcome) {
              case UNKNOWN_SOURCE ->
                  String.format(
                      "more than %s sources on \"%s\": dropped \"%s\"",
                      ServiceInbox.MAX_SOURCES, channel, channel.sourceOf(message));
              case TOO_LONG ->
                  String.format(
                      "too many sources of long messages on \"%s\": dropped one of \"%s\"",
                      channel, channel.sourceOf(message));
              default -> "inbox full";
            };
        configuration.log(
            LogLevelEnum.WARN, why + ": " + inbox.dropped() + " messages dropped so far");
      }
    }
  }

  /**
   * @param next prospective successor, which receives messages on channels that only it subscribes
   *     to; null if none
   */
  private record Served(Recipient present, Recipient next) {}

  private final AtomicLong misplaced = new AtomicLong();
  private volatile Served served;

  ServiceReceiver(Recipient service) {
    served = new Served(service, null);
  }

  void prepare(Recipient successor) {
    served = new Served(served.present, successor);
  }

  /** Undoes {@link #prepare}. */
  void forget() {
    served = new Served(served.present, null);
  }

  /** Routes everything to this service. */
  void turnTo(Recipient successor) {
    served = new Served(successor, null);
  }

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    Served now = served;
    String name = now.present.configuration.name();
    if (!channel.carries(message)) {
      refuse(channel, message);
    } else if (ServiceContract.isOrderToStop(name, channel, message)) {
      stop(now.present, (StopCommand) message);
    } else {
      Recipient recipient =
          now.present.isSubscribed(channel) || ServiceContract.concerns(name, channel, message)
              ? now.present
              : now.next;
      if (recipient == now.present || recipient != null && recipient.isSubscribed(channel)) {
        recipient.put(channel, message);
        served.present.life.wakeFor(channel); // re-read: may have moved to a successor
      }
    }
  }

  /**
   * A late one was meant for another situation, and one that comes twice for a service that may
   * have been started again since: without services a vehicle is out of control.
   */
  private void stop(Recipient service, StopCommand order) {
    Optional<String> late = service.configuration.lateness(order);
    if (late.isPresent()) {
      trouble("not stopped, because " + late.get() + ": " + order);
    } else if (!service.orders.isNew(order)) {
      trouble("not stopped, because the order arrived twice: " + order);
    } else {
      service.life.stopFor(order.stopAll() ? U2SAService.ALL_STOPPED : "it was ordered to stop");
    }
  }

  /** Rejects types on the wrong channel, because services act on the type alone. */
  private void refuse(Channel<?> channel, U2SAData message) {
    long count = misplaced.incrementAndGet();
    if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: limits the log
      trouble(
          String.format(
              "rejected on \"%s\", which does not carry %s (%s so far): %s",
              channel, message.type().name(), count, message));
    }
  }

  @Override
  public void trouble(String what) {
    served.present.configuration.log(LogLevelEnum.WARN, what);
  }
}
