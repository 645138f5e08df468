package org.u2sa.interfaces.mqtt;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.mqtt.failure.ConnectFailure;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.Origin;
import org.u2sa.messages.schema.U2SAData;

/** A service's MQTT connection with automatic reconnection. */
final class MqttConnection implements Connection, MqttSession.Owner {
  private static final int AT_LEAST_ONCE = 1;
  private static final int TOPICS_REMEMBERED = 1_024;
  private static final int MAX_TOPIC_LENGTH = 1_024; // limit of the embedded broker

  private final String address;
  private final String systemId;
  private final String serviceName;
  private final MessageCodec codec;
  private final Receiver receiver;
  private final String instance = OriginNumbers.newSender();
  private final OriginNumbers numbers = new OriginNumbers(instance);
  private final IncomingMessages incoming;
  private final RetainedTopics retained;
  private final MqttSubscriptions subscriptions;
  private final boolean isService; // a service, whose loss the broker reports
  private final TopicNames topics;
  private final Map<String, Topic> parsed = new ConcurrentHashMap<>(); // cache of parsed topics
  private final MqttLink link;
  private volatile long refusedBefore; // value at the last disconnect
  private volatile boolean closed;

  MqttConnection(
      String address,
      String systemId,
      String serviceName,
      MessageCodec codec,
      Receiver receiver,
      MqttClient client,
      boolean isService) {
    this.isService = isService && !systemId.equals(Topic.ANY_SYSTEM);
    this.address = address;
    this.systemId = systemId;
    this.serviceName = serviceName;
    this.codec = codec;
    this.receiver = receiver;
    topics = new TopicNames(systemId);
    incoming = new IncomingMessages(codec, receiver);
    retained = new RetainedTopics(incoming::refuse);
    subscriptions = new MqttSubscriptions(address, systemId, receiver::trouble);
    // Brokers drop the older of two clients with the same ID, so a restarted service must not reuse
    // its predecessor's, while a reconnection must reuse its own. Nor may the ID be derivable from
    // published data such as the instance: a broker that lets any user take any ID, such as
    // Mosquitto, would let a reader disconnect the service.
    link = new MqttLink(address, ClientIds.of(systemId, serviceName), this, client);
  }

  /**
   * Connects for the first time.
   *
   * @param options without the will; created for each attempt
   * @param patienceS time limit for all attempts [s]
   * @throws CommunicationException if the broker is unreachable within that time
   */
  void open(Supplier<MqttConnectOptions> options, double patienceS, Clock clock, Random random) {
    try {
      link.open(() -> withWill(options.get()), Clock.micros(patienceS), clock, random);
    } catch (MqttException | IllegalArgumentException e) {
      close();
      throw new CommunicationException(
          explained(e, options.get().getUserName(), clock.micros() / Clock.MICROS_PER_SECOND), e);
    }
  }

  private String explained(Exception failure, String user, long nowS) {
    return new ConnectFailure(address, user == null ? "" : user, Instant.ofEpochSecond(nowS))
        .text(failure, MqttSession.reason(failure));
  }

  private MqttConnectOptions withWill(MqttConnectOptions options) {
    if (isService) {
      ConnectionLost lost = new ConnectionLost();
      lost.serviceName(serviceName).status(ServiceStatus.FAILED).lastError("connection lost");
      lost.instance(instance).systemId(systemId);
      lost.freeze();
      Topic topic = Topic.of(systemId, Channels.HEALTH, lost);
      options.setWill(topic.toString(), codec.encode(lost), AT_LEAST_ONCE, false);
    }
    return options;
  }

  @Override
  public String instance() {
    return instance;
  }

  @Override
  public boolean publish(Channel<?> channel, U2SAData message) {
    if (closed || !channel.carries(message) || !isAddressed(message)) {
      incoming.refuse(1);
      return false;
    }
    String topic = topics.of(channel, message);
    OriginNumbers.Stream stream = numbers.on(topic);
    synchronized (stream) {
      return publish(channel, topic, message, stream.next());
    }
  }

  private boolean isAddressed(U2SAData message) {
    return !systemId.equals(Topic.ANY_SYSTEM) || !message.systemId().isEmpty();
  }

  private boolean publish(Channel<?> channel, String topic, U2SAData message, Origin origin) {
    try {
      MqttSession session = link.session();
      boolean sent = false;
      if (channel.isRetained()) {
        byte[] payload = codec.encode(message, origin);
        RetainedTopics.Published last = retained.publishing(topic, payload);
        sent = session != null && session.publish(topic, payload, true, true, last::confirm);
        if (sent) {
          last.settle(session);
        }
      } else if (session != null) {
        byte[] payload = codec.encode(message, origin);
        sent = session.publish(topic, payload, channel.deliversEvery(), false, null);
      }
      if (!sent && session == null) {
        incoming.refuse(1); // the broken link was already reported
      } else if (!sent) {
        incoming.refuse("publishing on \"" + channel + "\" failed: the broker is too slow");
        if (channel.isRetained()) {
          link.catchUpSoon(); // late subscribers rely on it
        }
      }
      return sent;
    } catch (MqttException | IllegalStateException e) { // IllegalStateException: message too long
      incoming.refuse("publishing on \"" + channel + "\" failed: " + MqttSession.reason(e));
      return false;
    }
  }

  @Override
  public boolean subscribe(Channel<?> channel) {
    subscriptions.want(channel);
    retained.forget(channel);
    incoming.forget(channel);
    MqttSession session = link.session();
    return !closed && (session == null || subscriptions.begin(session, channel));
  }

  @Override
  public boolean unsubscribe(Channel<?> channel) {
    subscriptions.forget(channel);
    MqttSession session = link.session();
    return !closed && (session == null || subscriptions.end(session, channel));
  }

  @Override
  public Set<String> refusedSubscriptions() {
    return subscriptions.refused();
  }

  /** Restores subscriptions and retained messages on a new session, on the link thread. */
  void renew(MqttSession session) throws MqttException, InterruptedException {
    retained.restore(session);
    subscriptions.renew(session);
  }

  /**
   * Completes requests that the session could not accept or that preceded it, on the link thread.
   * Returns whether everything is done.
   */
  boolean catchUp(MqttSession session) throws MqttException {
    subscriptions.renew(session);
    return retained.catchUp(session, numbers::on);
  }

  @Override
  public void arrived(String topicName, byte[] payload, boolean isOld) {
    if (topicName.length() > MAX_TOPIC_LENGTH) { // kept in several tables
      incoming.refuse("a message on a topic of " + topicName.length() + " characters");
      return;
    }
    Topic topic;
    try {
      topic = parsed(topicName);
    } catch (IllegalArgumentException e) {
      incoming.refuse("a message cannot be read: " + e.getMessage());
      return;
    }
    Channel<?> channel = subscriptions.named(topic.channel());
    if ((channel == null || channel.acceptsRetained()) && !retained.isNews(topicName, payload)) {
      return; // already received before the link broke
    }
    if (channel != null && isOld && !channel.acceptsRetained()) {
      // A retained command is ignored: it would be executed at every start.
      incoming.refuse("a retained message on " + topic + ": \"" + channel + "\" retains nothing");
    } else if (channel != null) { // otherwise it arrived during an unsubscribe
      incoming.hand(channel, topic, payload);
    }
  }

  @Override
  public void skipped(String topicName, int bytes) {
    String start =
        topicName.length() > MAX_TOPIC_LENGTH
            ? topicName.substring(0, MAX_TOPIC_LENGTH) + "..."
            : topicName;
    incoming.refuse("a message of " + bytes + " bytes on " + start + " is too long");
  }

  private Topic parsed(String topicName) {
    Topic known = parsed.get(topicName);
    if (known == null) {
      known = Topic.parse(topicName);
      if (parsed.size() < TOPICS_REMEMBERED) {
        parsed.put(topicName, known);
      }
    }
    return known;
  }

  @Override
  public void lost(MqttSession session, String why) {
    link.lost(session, why);
  }

  void interrupted(String why) {
    refusedBefore = incoming.refused();
    receiver.trouble(why);
  }

  /** Called when the link and all subscriptions are restored. */
  void restored(double afterS) {
    receiver.trouble(
        String.format(
            "connection to %s restored, subscriptions %s, after %.1f s; %d messages could not be "
                + "sent in between",
            address,
            subscriptions.refused().isEmpty() ? "too" : "except " + subscriptions.refused(),
            afterS,
            incoming.refused() - refusedBefore));
  }

  void trouble(String what) {
    receiver.trouble(what);
  }

  void unconfirmed(long messages) {
    incoming.refuse(messages);
  }

  @Override
  public long missed() {
    return incoming.missed();
  }

  @Override
  public long refused() {
    return incoming.refused();
  }

  @Override
  public void close() {
    if (!closed) {
      closed = true;
      link.close();
    }
  }

  /**
   * Cache of outgoing topics by channel and type. Without a system ID, each message's system ID is
   * used, and nothing is cached.
   */
  static final class TopicNames {
    private final String systemId;
    private final Map<String, Map<List<String>, String>> composed = new ConcurrentHashMap<>();

    TopicNames(String systemId) {
      this.systemId = systemId;
    }

    /** Topic of a message; topics with a source are not cached. */
    String of(Channel<?> channel, U2SAData message) {
      boolean isAny = systemId.equals(Topic.ANY_SYSTEM);
      if (isAny || channel.isRetained()) {
        return Topic.of(isAny ? message.systemId() : systemId, channel, message).toString();
      }
      return composed
          .computeIfAbsent(channel.name(), name -> new ConcurrentHashMap<>())
          .computeIfAbsent(
              message.typeChain(), chain -> Topic.of(systemId, channel, message).toString());
    }
  }
}
