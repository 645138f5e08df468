package org.u2sa.service;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.schema.U2SAData;

/**
 * Registration, publishing and subscribing of a service (thesis 3.2.1.2–3.2.1.4); failures are
 * logged and return false.
 */
final class ServiceMessaging {
  private final U2SAService service;
  private final ServiceWiring wiring;
  private final AtomicLong refused = new AtomicLong(); // the service's messages
  private final Registrations registrations;

  ServiceMessaging(U2SAService service, ServiceWiring wiring) {
    this.service = service;
    this.wiring = wiring;
    registrations = wiring.registrations();
  }

  boolean begin() {
    return attempt("connecting", wiring::isReady);
  }

  boolean registerPublisher(Channel<?> channel) {
    return attempt(
        "registering as publisher of " + channel, () -> wiring.registerPublisher(channel));
  }

  boolean registerSubscriber(Channel<?> channel) {
    return attempt(
        "registering as subscriber of " + channel, () -> wiring.registerSubscriber(channel));
  }

  boolean unregisterSubscriber(Channel<?> channel) {
    return attempt("unregistering from " + channel, () -> wiring.unregisterSubscriber(channel));
  }

  boolean publish(U2SAData data) {
    Optional<Channel<?>> channel = registrations.channelFor(data);
    return channel.isPresent()
        ? publish(channel.get(), data)
        : refuse("not registered as a publisher of " + data.type().name() + ": not published");
  }

  boolean publish(Channel<?> channel, U2SAData data) {
    if (wiring.isSilent()) {
      return false; // the successor has replaced this service
    }
    if (service.loop != null) {
      service.loop.awaitTurn();
    }
    long nowMicros = service.clock().micros();
    if (!data.isFrozen()) {
      if (data.systemId().isEmpty()) {
        data.systemId(service.context().systemId());
      }
      if (data.timestamp().isEmpty()) {
        data.timestamp(nowMicros);
      }
      data.freeze();
    }
    try {
      if (wiring.publish(channel, data, nowMicros)) {
        return true;
      }
      if (Long.bitCount(refused.incrementAndGet()) == 1) { // 1, 2, 4, 8…: limits the log
        refuse("publishing on " + channel + " was refused: " + data);
      }
      return false;
    } catch (CommunicationException e) {
      return refuse("publishing on " + channel + " failed: " + e.getMessage());
    }
  }

  /**
   * The role's standard channel for publishing messages of the class; logs an error if there is
   * none.
   */
  Optional<Channel<?>> toPublish(Class<? extends U2SAData> dataType) {
    return orRefuse(service.role().channelToPublish(dataType), "publishes", dataType);
  }

  /**
   * The role's standard channel for receiving messages of the class; logs an error if there is
   * none.
   */
  Optional<Channel<?>> toSubscribe(Class<? extends U2SAData> dataType) {
    return orRefuse(service.role().channelToSubscribe(dataType), "receives", dataType);
  }

  private Optional<Channel<?>> orRefuse(
      Optional<Channel<?>> standard, String does, Class<? extends U2SAData> dataType) {
    if (standard.isEmpty()) {
      refuse(
          String.format(
              "no standard channel on which a %s %s %s: register with a channel instead, one of %s or your own",
              service.role(), does, dataType.getSimpleName(), Channels.all()));
    }
    return standard;
  }

  /** The channel of that name; logs an error if the name is invalid. */
  Optional<Channel<?>> named(String channelName) {
    try {
      return Optional.of(Channels.namedOrNew(channelName));
    } catch (IllegalArgumentException e) {
      refuse(e.getMessage());
      return Optional.empty();
    }
  }

  private boolean refuse(String why) {
    service.log(LogLevelEnum.ERROR, why);
    return false;
  }

  private boolean attempt(String what, BooleanSupplier action) {
    try {
      return action.getAsBoolean() || refuse(what + " was refused");
    } catch (CommunicationException e) {
      return refuse(what + " failed: " + e.getMessage());
    }
  }
}
