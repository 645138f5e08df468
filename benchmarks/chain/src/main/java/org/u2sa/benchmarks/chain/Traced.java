package org.u2sa.benchmarks.chain;

import java.util.function.LongConsumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.Execution;
import org.u2sa.service.inbox.ServiceInbox;

/** Follows a measurement through a service: what it publishes goes back to what it is handling. */
final class Traced implements Execution {
  private final Causes causes;
  private final LongConsumer onNavigation; // takes when the measurement was sent [ns]
  private long handledNanos = Causes.NONE; // of the service's thread

  Traced(Causes causes, LongConsumer onNavigation) {
    this.causes = causes;
    this.onNavigation = onNavigation;
  }

  /** When the measurement was sent that the message being handled goes back to [ns]. */
  long handledNanos() {
    return handledNanos;
  }

  @Override
  public ServiceInbox.Delivery receives(ServiceInbox.Delivery waiting) {
    if (waiting != null) {
      handledNanos = causes.of(waiting.message());
      if (waiting.channel().equals(Channels.NAVIGATION) && handledNanos != Causes.NONE) {
        onNavigation.accept(handledNanos);
      }
    }
    return waiting;
  }

  @Override
  public Outlet outlet(Outlet connection) {
    return (channel, message) -> {
      note(channel, message);
      return connection.publish(channel, message);
    };
  }

  private void note(Channel<?> channel, U2SAData message) {
    if (channel.equals(Channels.STATE)
        || channel.equals(Channels.NAVIGATION)
        || channel.equals(Channels.ACTUATION)) {
      causes.put(message, handledNanos);
    }
  }

  @Override
  public void steps() {
    handledNanos = Causes.NONE;
  }
}
