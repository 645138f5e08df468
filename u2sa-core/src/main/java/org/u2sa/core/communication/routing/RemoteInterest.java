package org.u2sa.core.communication.routing;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.mqtt.OriginNumbers;

/**
 * Topics of local services' messages at the broker, and whether any remote client subscribes to
 * them. Thread-safe; called for every message.
 */
public final class RemoteInterest {
  private final String systemId;
  private final RemoteSubscriptions subscriptions;
  private final OriginNumbers numbers;
  private final Map<String, List<Destination>> destinations =
      new ConcurrentHashMap<>(); // by channel

  /** Interest in a system's messages. */
  public RemoteInterest(String systemId, RemoteSubscriptions subscriptions, OriginNumbers numbers) {
    this.systemId = systemId;
    this.subscriptions = subscriptions;
    this.numbers = numbers;
  }

  /** Topic for messages of one type on one channel. */
  public final class Destination {
    private final List<String> typeChain;
    private final String topic;
    private final OriginNumbers.Stream stream;
    private volatile Answer last;

    /** Whether the topic is subscribed to in a version of the subscriptions. */
    private record Answer(boolean wanted, int version) {}

    Destination(List<String> typeChain, String topic) {
      this.typeChain = typeChain;
      this.topic = topic;
      stream = numbers.on(topic);
      last = ask();
    }

    private Answer ask() {
      int version = subscriptions.version(); // read first, so that concurrent changes are noticed
      return new Answer(subscriptions.wants(topic), version);
    }

    /** Topic of the message. */
    public String topic() {
      return topic;
    }

    /** Sequence numbers of the messages sent to it. */
    public OriginNumbers.Stream stream() {
      return stream;
    }

    /** Whether a remote client has subscribed to it. */
    public boolean isWanted() {
      Answer answer = last;
      if (answer.version != subscriptions.version()) {
        answer = ask();
        last = answer;
      }
      return answer.wanted;
    }
  }

  /** Destination of a non-retained message with this {@code typeChain}. */
  public Destination destination(Channel<?> channel, List<String> typeChain) {
    List<Destination> ofChannel = destinations.get(channel.name());
    Destination known = ofChannel == null ? null : find(ofChannel, typeChain);
    return known == null ? add(channel, typeChain) : known;
  }

  /** Linear search: a channel has few types, nearly always identical lists. */
  private static Destination find(List<Destination> ofChannel, List<String> typeChain) {
    for (Destination destination : ofChannel) {
      if (destination.typeChain == typeChain || destination.typeChain.equals(typeChain)) {
        return destination;
      }
    }
    return null;
  }

  private synchronized Destination add(Channel<?> channel, List<String> typeChain) {
    List<Destination> ofChannel =
        destinations.computeIfAbsent(channel.name(), name -> new CopyOnWriteArrayList<>());
    Destination known = find(ofChannel, typeChain);
    if (known == null) {
      known = new Destination(typeChain, new Topic(systemId, channel.name(), typeChain).toString());
      ofChannel.add(known);
    }
    return known;
  }
}
