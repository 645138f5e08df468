package org.u2sa.service;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.u2sa.interfaces.Clock;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.MqttTransport;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.messages.MessageCodec;
import org.u2sa.messages.U2SAData;

/** A service's side of its communication: the connection and what was registered on it. */
final class ServiceWiring {
  private final ServiceRole role;
  private final Transport transport;
  private final String serviceName;
  private final Receiver receiver;
  private final List<Channel<?>> published = new CopyOnWriteArrayList<>();
  private final List<Channel<?>> subscribed = new CopyOnWriteArrayList<>();
  private final Map<Channel<?>, Long> deadlinesMicros = new ConcurrentHashMap<>();
  private volatile Connection connection; // open or null; written under this
  private long refused; // by the connection, when it was closed
  private boolean closed;

  ServiceWiring(ServiceContext context, ServiceRole role, String serviceName, Receiver receiver) {
    this.role = role;
    this.serviceName = serviceName;
    this.receiver = receiver;
    this.transport = context.transport().orElseGet(() -> remote(context));
  }

  private static Transport remote(ServiceContext context) {
    return new MqttTransport(
        context.configuration().getVariable(ServiceVariables.MANAGER_IP),
        context.configuration().getVariable(ServiceVariables.MANAGER_PORT),
        context.systemId(),
        new MessageCodec(context.messageTypes()));
  }

  /**
   * The connection, made at the first call, with the service contract's subscriptions.
   *
   * @throws CommunicationException if the Communication Manager cannot be reached
   */
  Connection connection() {
    Connection open = connection;
    return open != null ? open : connect();
  }

  private synchronized Connection connect() {
    if (closed) {
      throw new CommunicationException(
          "service \"" + serviceName + "\" has ended its communication");
    }
    if (connection == null) {
      Connection made = transport.connect(serviceName, receiver);
      connection = made;
      for (Channel<?> channel : ContractResponder.CHANNELS) {
        made.subscribe(channel);
      }
    }
    return connection;
  }

  boolean publish(Channel<?> channel, U2SAData data) {
    return connection().publish(channel, data);
  }

  boolean registerPublisher(Channel<?> channel) {
    connection();
    if (!published.contains(channel)) {
      published.add(channel);
    }
    return true;
  }

  boolean unregisterPublisher(Channel<?> channel) {
    return published.remove(channel);
  }

  boolean registerSubscriber(Channel<?> channel) {
    if (!subscribed.contains(channel)) {
      subscribed.add(channel);
    }
    return connection().subscribe(channel);
  }

  boolean unregisterSubscriber(Channel<?> channel) {
    boolean contract = ContractResponder.CHANNELS.contains(channel);
    return subscribed.remove(channel) && (contract || connection().unsubscribe(channel));
  }

  /** Sets the age at which the channel's messages count as absent [µs]. */
  void deadline(Channel<?> channel, long micros) {
    deadlinesMicros.put(channel, micros);
  }

  /** {@link #deadline}; {@link Clock#NEVER} if the service's author set none. */
  long deadlineMicros(Channel<?> channel) {
    return deadlinesMicros.getOrDefault(channel, Clock.NEVER);
  }

  /** Whether the service's author asked for the channel. */
  boolean isSubscribed(Channel<?> channel) {
    return subscribed.contains(channel);
  }

  List<Channel<?>> published() {
    return published;
  }

  List<Channel<?>> subscribed() {
    return subscribed;
  }

  /** The registered channel on which the message goes out; the one with the nearest type wins. */
  Optional<Channel<?>> channelFor(U2SAData data) {
    Channel<?> nearest = null;
    for (Channel<?> channel : published) {
      if (channel.carries(data) && (nearest == null || depth(channel) > depth(nearest))) {
        nearest = channel;
      }
    }
    return Optional.ofNullable(nearest);
  }

  private static int depth(Channel<?> channel) {
    return channel.type().chain().size();
  }

  Channel<?> channelToPublish(Class<? extends U2SAData> dataType) {
    return role.channelToPublish(dataType)
        .orElseThrow(() -> noStandardChannel("publishes", dataType));
  }

  Channel<?> channelToSubscribe(Class<? extends U2SAData> dataType) {
    return role.channelToSubscribe(dataType)
        .orElseThrow(() -> noStandardChannel("receives", dataType));
  }

  private IllegalArgumentException noStandardChannel(
      String does, Class<? extends U2SAData> dataType) {
    return new IllegalArgumentException(
        "no standard channel on which a "
            + role
            + " "
            + does
            + " "
            + dataType.getSimpleName()
            + ": register with a channel instead, one of "
            + Channels.all()
            + " or your own");
  }

  synchronized long refused() {
    return connection == null ? refused : connection.refused();
  }

  synchronized void close() {
    closed = true;
    if (connection != null) {
      connection.close();
      refused = connection.refused();
      connection = null;
    }
  }
}
