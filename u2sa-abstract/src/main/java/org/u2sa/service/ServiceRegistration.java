package org.u2sa.service;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.messages.schema.U2SAData;

/**
 * Registers a service for channels (thesis 3.2.1.2–3.2.1.4); failures are logged and return false.
 */
record ServiceRegistration(ServiceConnection connection, ServiceRole role) {
  boolean begin() {
    return attempt(
        "connecting",
        () -> {
          connection.begin();
          return true;
        });
  }

  boolean registerPublisher(Channel<?> channel) {
    return attempt(
        "registering as publisher of " + channel, () -> connection.registerPublisher(channel));
  }

  boolean registerSubscriber(Channel<?> channel) {
    return attempt(
        "registering as subscriber of " + channel, () -> connection.registerSubscriber(channel));
  }

  boolean unregisterSubscriber(Channel<?> channel) {
    return attempt("unregistering from " + channel, () -> connection.unregisterSubscriber(channel));
  }

  /** Standard channel for publishing the class; logs an error if the class has none. */
  Optional<Channel<?>> toPublish(Class<? extends U2SAData> dataType) {
    return orRefuse(role.channelToPublish(dataType), "publishes", dataType);
  }

  Optional<Channel<?>> toSubscribe(Class<? extends U2SAData> dataType) {
    return orRefuse(role.channelToSubscribe(dataType), "receives", dataType);
  }

  private Optional<Channel<?>> orRefuse(
      Optional<Channel<?>> standard, String does, Class<? extends U2SAData> dataType) {
    if (standard.isEmpty()) {
      connection.refuse(
          String.format(
              "no standard channel on which a %s %s %s: register with a channel instead, one of %s or your own",
              role, does, dataType.getSimpleName(), Channels.all()));
    }
    return standard;
  }

  /** Channel of that name; logs an error if the name is invalid. */
  Optional<Channel<?>> named(String channelName) {
    try {
      return Optional.of(Channels.namedOrNew(channelName));
    } catch (IllegalArgumentException e) {
      connection.refuse(e.getMessage());
      return Optional.empty();
    }
  }

  private boolean attempt(String what, BooleanSupplier action) {
    try {
      return action.getAsBoolean() || connection.refuse(what + " was refused");
    } catch (CommunicationException e) {
      return connection.refuse(what + " failed: " + e.getMessage());
    }
  }
}
