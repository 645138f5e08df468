package org.u2sa.interfaces.communication;

import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.Origin;
import org.u2sa.messages.schema.U2SAData;

/**
 * One service's MQTT connection: what it sends, and what it is subscribed to. When the broker or
 * the way to it is gone, it comes back by itself.
 */
final class MqttConnection implements Connection {
  private static final int AT_LEAST_ONCE = 1;
  private static final int TOPICS_REMEMBERED = 1_024;

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
  private final TopicNames topics;
  private final Map<String, Topic> parsed = new ConcurrentHashMap<>(); // topics that came before
  private final MqttLink link;
  private volatile long refusedBefore; // when the link broke
  private volatile boolean closed;

  /** Takes what the connection needs; {@link #open} makes it. */
  MqttConnection(
      String address,
      String systemId,
      String serviceName,
      MessageCodec codec,
      Receiver receiver,
      MqttClient client) {
    this.address = address;
    this.systemId = systemId;
    this.serviceName = serviceName;
    this.codec = codec;
    this.receiver = receiver;
    topics = new TopicNames(systemId);
    incoming = new IncomingMessages(codec, receiver);
    retained = new RetainedTopics(incoming::refuse);
    subscriptions = new MqttSubscriptions(address, systemId, receiver::trouble);
    // Brokers drop the older of two clients with one ID. So a restarted service must not take its
    // predecessor's, while a connection that comes back takes its own from the broken session.
    // Nor may it be guessed from what is published, as the instance is: a broker that lets any user
    // take any ID, such as Mosquitto, would let a reader throw the service out.
    link = new MqttLink(address, clientId(systemId, serviceName), this, client);
  }

  private static String clientId(String systemId, String serviceName) {
    return String.join(
        "/", TopicLevel.of(systemId), TopicLevel.of(serviceName), UUID.randomUUID().toString());
  }

  /**
   * Connects for the first time.
   *
   * @param options how, without the will; made anew for each attempt
   * @param patienceS how long to try [s]
   * @throws CommunicationException if the broker is not there in all that time
   */
  void open(Supplier<MqttConnectOptions> options, double patienceS, Clock clock, Random random) {
    try {
      link.open(() -> withWill(options.get()), Clock.micros(patienceS), clock, random);
    } catch (MqttException | IllegalArgumentException e) {
      close();
      throw new CommunicationException(
          String.format(
              "no Communication Manager at %s: %s; is it running, and is the address right?",
              address, MqttSession.reason(e)),
          e);
    }
  }

  /** Adds what the broker says in the service's place when the connection breaks. */
  private MqttConnectOptions withWill(MqttConnectOptions options) {
    if (!systemId.equals(Topic.ANY_SYSTEM)) {
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
    if (closed || !channel.carries(message) || systemId.equals(Topic.ANY_SYSTEM)) {
      incoming.refuse(1);
      return false;
    }
    String topic = topics.of(channel, message);
    OriginNumbers.Stream stream = numbers.on(topic);
    synchronized (stream) {
      return publish(channel, topic, message, stream.next());
    }
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
        incoming.refuse(1); // that the link is broken was told
      } else if (!sent) {
        incoming.refuse("publishing on \"" + channel + "\" failed: the broker is too slow");
        if (channel.isRetained()) {
          link.catchUpSoon(); // whoever subscribes later relies on it
        }
      }
      return sent;
    } catch (MqttException | IllegalStateException e) { // the latter: too long
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

  /**
   * Renews on a new session what the broken one had, before it is in use. Called on the link
   * thread.
   */
  void renew(MqttSession session) throws MqttException, InterruptedException {
    retained.restore(session);
    subscriptions.renew(session);
  }

  /**
   * Does on a session in use what was asked for while it was not, or what it could not take then.
   * Called on the link thread.
   *
   * @return whether nothing is left to do
   */
  boolean catchUp(MqttSession session) throws MqttException {
    subscriptions.renew(session);
    return retained.catchUp(session, numbers::on);
  }

  /**
   * A message came in, on the session's thread. Must not throw.
   *
   * @param isOld whether it was published before the subscription that brings it
   */
  void arrived(String topicName, byte[] payload, boolean isOld) {
    Topic topic;
    try {
      topic = parsed(topicName);
    } catch (IllegalArgumentException e) {
      incoming.refuse("a message cannot be read: " + e.getMessage());
      return;
    }
    Channel<?> channel = subscriptions.named(topic.channel());
    if ((channel == null || channel.isRetained()) && !retained.isNews(topicName, payload)) {
      return; // known since before the link broke
    }
    if (channel != null && isOld && !channel.isRetained()) {
      // An order that somebody left behind is none: it would be obeyed at each start.
      incoming.refuse("a retained message on " + topic + ": \"" + channel + "\" retains nothing");
    } else if (channel != null) { // otherwise it came in while unsubscribing
      incoming.hand(channel, topic, payload);
    }
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

  /** The session broke and will not be of use again. Called on the session's threads. */
  void lost(MqttSession session, String why) {
    link.lost(session, why);
  }

  /** The link broke. */
  void interrupted(String why) {
    refusedBefore = incoming.refused();
    receiver.trouble(why);
  }

  /** The link and all subscriptions are back. */
  void restored(double afterS) {
    receiver.trouble(
        String.format(
            "connection to %s restored, subscriptions %s, after %.1f s; %d messages could not be sent meanwhile",
            address,
            subscriptions.refused().isEmpty() ? "too" : "except " + subscriptions.refused(),
            afterS,
            incoming.refused() - refusedBefore));
  }

  /** The link does not come back, for a reason not told before. */
  void trouble(String what) {
    receiver.trouble(what);
  }

  /** Counts messages of which nobody can say that they have arrived. */
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

  /** The topics of what one system sends, composed once for each channel and type. */
  static final class TopicNames {
    private final String systemId;
    private final Map<String, Map<List<String>, String>> composed = new ConcurrentHashMap<>();

    TopicNames(String systemId) {
      this.systemId = systemId;
    }

    /** The topic of a message; those that a source of its own tells apart are not remembered. */
    String of(Channel<?> channel, U2SAData message) {
      if (channel.isRetained()) {
        return Topic.of(systemId, channel, message).toString();
      }
      return composed
          .computeIfAbsent(channel.name(), name -> new ConcurrentHashMap<>())
          .computeIfAbsent(
              message.typeChain(), chain -> Topic.of(systemId, channel, message).toString());
    }
  }
}
