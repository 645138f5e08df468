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
import org.u2sa.core.communication.routing.Publication;
import org.u2sa.core.communication.routing.RemoteSubscriptions;
import org.u2sa.core.communication.routing.RetainedTable;
import org.u2sa.core.communication.routing.TopicRoute;

/**
 * Routes messages from publishers to subscribers, and retained messages to new subscribers. Runs
 * entirely on the network's thread and bypasses Moquette, where each message would change threads
 * at least twice and wait in queues that drop on overflow. A subscriber receives a message either
 * as retained, if it was published before the subscription, or as new: none is missed, and none is
 * followed by an older one.
 */
final class MessageRouter {
  /** Delivers messages of remote clients to the services of this process. */
  interface Reader {
    /** Whether any service subscribes to the topic; otherwise {@link #read} is not called. */
    boolean wants(String topic);

    /** Reads one message. The caller keeps ownership of the payload. Must not block. */
    void read(String topic, ByteBuf payload);
  }

  /** A message of this process on its way to the network's thread. */
  private record Outgoing(
      String topic, boolean eachMatters, boolean isRetained, byte[] payload, Runnable sent) {}

  private final RemoteSubscriptions subscriptions;
  private final RetainedTable retained;
  private final ClientTable clients;
  private final Queue<Outgoing> outgoing = new ConcurrentLinkedQueue<>();
  private final AtomicBoolean isSending = new AtomicBoolean();
  private volatile Reader reader; // null if no service of this process listens
  private volatile EventLoop loop;

  MessageRouter(RemoteSubscriptions subscriptions, RetainedTable retained, ClientTable clients) {
    this.subscriptions = subscriptions;
    this.retained = retained;
    this.clients = clients;
  }

  /** Attaches the services of this process. */
  void join(Reader services) {
    reader = services;
  }

  /** Sets the network's thread, on which messages of this process are sent. */
  void runOn(EventLoop network) {
    loop = network;
  }

  /**
   * Delivers a client's message to all subscribers. Called on the network's thread.
   *
   * @param publisher the client
   */
  void route(String topic, ByteBuf payload, boolean eachMatters, Client publisher) {
    Reader services = reader;
    if (services != null && services.wants(topic)) {
      services.read(topic, payload);
    }
    publisher.subscriberIsBehind(send(subscriptions.route(topic), eachMatters, payload));
  }

  /**
   * Sends a message of this process. May be called on any thread; the order of each thread's
   * messages is preserved.
   *
   * @param isRetained whether late subscribers receive it too
   * @param sent called on the network's thread once it has been queued on every subscriber's
   *     connection
   */
  void send(String topic, boolean eachMatters, boolean isRetained, byte[] payload, Runnable sent) {
    outgoing.add(new Outgoing(topic, eachMatters, isRetained, payload, sent));
    if (!isSending.getAndSet(true)) {
      Client.execute(loop, this::sendOutgoing);
    }
  }

  private void sendOutgoing() {
    isSending.set(false); // first, so that messages added from here on reschedule the sending
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
   * Sends a client the retained messages matching its new filters, each once. Called on the
   * network's thread.
   *
   * @param filters each with whether it asks for QoS 1
   * @return the number of messages sent
   */
  int sendRetained(Map<String, Boolean> filters, Client subscriber) {
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

  /** Returns whether a subscriber is behind. */
  private boolean send(TopicRoute route, boolean eachMatters, ByteBuf payload) {
    if (!route.isWanted()) {
      return false;
    }
    boolean isBehind = false;
    Publication publication = new Publication(route, payload, false);
    try {
      for (TopicRoute.Listener listener : route.listeners()) {
        Client session = clients.of(listener.connection());
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
