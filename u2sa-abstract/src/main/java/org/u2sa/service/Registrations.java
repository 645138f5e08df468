package org.u2sa.service;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;

/** Channels that a service registered to publish on or subscribe to. */
final class Registrations {
  private final CopyOnWriteArrayList<Channel<?>> published = new CopyOnWriteArrayList<>();
  private final CopyOnWriteArrayList<Channel<?>> subscribed = new CopyOnWriteArrayList<>();
  private final Map<Channel<?>, Long> deadlinesMicros = new ConcurrentHashMap<>();
  private final Map<Channel<?>, Consumer<U2SAData>> handlers = new ConcurrentHashMap<>();

  List<Channel<?>> published() {
    return published;
  }

  List<Channel<?>> subscribed() {
    return subscribed;
  }

  void publish(Channel<?> channel) {
    published.addIfAbsent(channel);
  }

  void subscribe(Channel<?> channel) {
    subscribed.addIfAbsent(channel);
  }

  /** Whether the service's author subscribed to the channel. */
  boolean isSubscribed(Channel<?> channel) {
    return subscribed.contains(channel);
  }

  /** Whether the service receives the channel, for itself or for the service contract. */
  boolean listensTo(Channel<?> channel) {
    return isSubscribed(channel) || ServiceContract.CHANNELS.contains(channel);
  }

  /** Sets the age above which messages are dropped [µs]. */
  void deadline(Channel<?> channel, long micros) {
    deadlinesMicros.put(channel, micros);
  }

  /** {@link Clock#NEVER} if none. */
  long deadlineMicros(Channel<?> channel) {
    Long micros = deadlinesMicros.get(channel);
    return micros == null ? Clock.NEVER : micros;
  }

  <T extends U2SAData> void handler(Channel<T> channel, Consumer<? super T> action) {
    Class<T> type = channel.type().messageClass();
    handlers.put(channel, message -> action.accept(type.cast(message)));
  }

  Consumer<U2SAData> handlerOr(Channel<?> channel, Consumer<U2SAData> other) {
    return handlers.getOrDefault(channel, other);
  }

  /** Registered channel for publishing the message; the closest type wins. */
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
}
