package org.u2sa.core.communication;

import io.moquette.broker.subscriptions.Topic;
import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.EventLoop;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * Takes messages from publishers to subscribers, and what is retained to new subscribers. All of it
 * happens on the network's thread, past Moquette, in which each message would change threads twice
 * or more and wait in queues that drop what does not fit. So a message reaches a subscriber either
 * as a retained one, if it was published before the subscription, or as a new one: none is missed,
 * and none is followed by an older one.
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
  private record Outgoing(
      String topic, boolean eachMatters, boolean isRetained, byte[] payload, Runnable sent) {}

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
   * Hands a client's message to all that listen. Called on the network's thread.
   *
   * @param publisher the client
   */
  void route(String topic, ByteBuf payload, boolean eachMatters, ClientSession publisher) {
    Reader services = reader;
    if (services != null && services.wants(topic)) {
      services.read(topic, payload);
    }
    publisher.subscriberIsBehind(send(subscriptions.route(topic), eachMatters, payload));
  }

  /**
   * Sends a message of this process. May be called on any thread; what one thread sends leaves in
   * its order.
   *
   * @param isRetained whether it is also for those who subscribe later
   * @param sent called on the network's thread once it was handed to each listener's connection
   */
  void send(String topic, boolean eachMatters, boolean isRetained, byte[] payload, Runnable sent) {
    outgoing.add(new Outgoing(topic, eachMatters, isRetained, payload, sent));
    if (!isSending.getAndSet(true)) {
      ClientSession.execute(loop, this::sendOutgoing);
    }
  }

  private void sendOutgoing() {
    isSending.set(false); // first: what is added from here on comes again
    for (Outgoing next = outgoing.poll(); next != null; next = outgoing.poll()) {
      try {
        if (next.isRetained) {
          retained.enterLocal(next.topic, next.payload);
        }
        send(
            subscriptions.route(next.topic),
            next.eachMatters,
            Unpooled.wrappedBuffer(next.payload));
      } finally {
        next.sent.run();
      }
    }
  }

  /**
   * Sends a client what is retained on the topics that its new filters match, each once. Called on
   * the network's thread.
   *
   * @param filters and for each whether each message matters
   * @return how many messages that were
   */
  int sendRetained(Map<String, Boolean> filters, ClientSession subscriber) {
    Map<RetainedTable.Retained, Boolean> wanted = new LinkedHashMap<>();
    filters.forEach(
        (filter, eachMatters) ->
            retained
                .matching(new Topic(filter))
                .forEach(message -> wanted.merge(message, eachMatters, Boolean::logicalOr)));
    wanted.forEach(
        (message, eachMatters) -> {
          ByteBuf payload = Unpooled.wrappedBuffer(message.payload());
          Publication publication = new Publication(new TopicRoute(message.topic()), payload, true);
          subscriber.deliver(publication, eachMatters);
          publication.release();
        });
    return wanted.size();
  }

  /** Returns whether a listener is behind. */
  private boolean send(TopicRoute route, boolean eachMatters, ByteBuf payload) {
    if (!route.isWanted()) {
      return false;
    }
    boolean isBehind = false;
    Publication publication = new Publication(route, payload, false);
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
