package org.u2sa.core.communication;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.EventLoop;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.handler.codec.mqtt.MqttQoS;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * Takes messages from publishers to subscribers past Moquette, in which each would change threads
 * twice or more and wait in queues that drop what does not fit. What is or was retained on its
 * topic goes through Moquette, which keeps it, and so do wills. Messages of one topic go one way,
 * so that their order stays.
 */
final class MessageRouter {
  /** Takes what remote clients publish to the services of this process. */
  interface Reader {
    /** Whether any service listens to the topic; otherwise {@link #read} is not called. */
    boolean wants(String topic);

    /** Takes one message. The payload stays the caller's. Must not block. */
    void read(String topic, ByteBuf payload);
  }

  /** A message of this process on its way to the network's thread. */
  private record Outgoing(TopicRoute route, boolean eachMatters, byte[] payload, Runnable sent) {}

  private final RemoteSubscriptions subscriptions;
  private final RetainedTable retained;
  private final Map<String, ClientSession> connections;
  private final Queue<Outgoing> outgoing = new ConcurrentLinkedQueue<>();
  private final AtomicBoolean isSending = new AtomicBoolean();
  private volatile Reader reader; // null: no service of this process listens
  private volatile EventLoop loop;

  /**
   * @param connections Moquette's clients, by connection
   */
  MessageRouter(
      RemoteSubscriptions subscriptions,
      RetainedTable retained,
      Map<String, ClientSession> connections) {
    this.subscriptions = subscriptions;
    this.retained = retained;
    this.connections = connections;
  }

  /** Joins the services of this process. */
  void join(Reader services) {
    reader = services;
  }

  /** Sets the network's thread, on which messages of this process are sent. */
  void runOn(EventLoop network) {
    loop = network;
  }

  /**
   * Hands a client's message to all that listen. Called on the client's thread.
   *
   * @param publisher the client
   * @return whether it was done; otherwise Moquette has to
   */
  boolean route(MqttPublishMessage publish, ClientSession publisher) {
    String topic = publish.variableHeader().topicName();
    if (publish.fixedHeader().isRetain() || retained.topics().contains(topic)) {
      return false;
    }
    TopicRoute route = subscriptions.route(topic);
    if (route == null) {
      return false;
    }
    Reader services = reader;
    if (services != null && services.wants(topic)) {
      services.read(topic, publish.content());
    }
    boolean eachMatters = publish.fixedHeader().qosLevel() != MqttQoS.AT_MOST_ONCE;
    publisher.subscriberIsBehind(send(route, eachMatters, publish.content()));
    return true;
  }

  /** Who listens to a topic of this process on which nothing is retained; null: ask Moquette. */
  TopicRoute routeOf(String topic) {
    return loop == null || retained.topics().contains(topic) ? null : subscriptions.route(topic);
  }

  /**
   * Sends a message of this process. May be called on any thread; what one thread sends leaves in
   * its order.
   *
   * @param sent called on the network's thread once it was handed to each listener's connection
   */
  void send(TopicRoute route, boolean eachMatters, byte[] payload, Runnable sent) {
    outgoing.add(new Outgoing(route, eachMatters, payload, sent));
    if (!isSending.getAndSet(true)) {
      ClientSession.execute(loop, this::sendOutgoing);
    }
  }

  private void sendOutgoing() {
    isSending.set(false); // first: what is added from here on comes again
    for (Outgoing next = outgoing.poll(); next != null; next = outgoing.poll()) {
      try {
        send(next.route, next.eachMatters, Unpooled.wrappedBuffer(next.payload));
      } finally {
        next.sent.run();
      }
    }
  }

  /** Returns whether a listener is behind. */
  private boolean send(TopicRoute route, boolean eachMatters, ByteBuf payload) {
    if (!route.isWanted()) {
      return false;
    }
    boolean isBehind = false;
    Publication publication = new Publication(route, payload);
    try {
      for (TopicRoute.Listener listener : route.listeners()) {
        ClientSession session = connections.get(listener.connection());
        if (session != null) {
          isBehind |= session.deliver(publication, eachMatters && listener.eachMatters());
        }
      }
    } finally {
      publication.release();
    }
    return isBehind;
  }
}
