package org.u2sa.interfaces.communication;

import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.eclipse.paho.client.mqttv3.IMqttDeliveryToken;
import org.eclipse.paho.client.mqttv3.MqttAsyncClient;
import org.eclipse.paho.client.mqttv3.MqttCallbackExtended;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.eclipse.paho.client.mqttv3.MqttMessage;
import org.eclipse.paho.client.mqttv3.persist.MemoryPersistence;
import org.u2sa.messages.MalformedMessageException;
import org.u2sa.messages.MessageCodec;
import org.u2sa.messages.U2SAData;

/** One service's MQTT client. Reconnects by itself and then renews its subscriptions. */
final class MqttConnection implements Connection {
  private static final int AT_MOST_ONCE = 0;
  private static final int AT_LEAST_ONCE = 1;
  private static final long ANSWER_WITHIN_MS = 5_000;
  private static final int KEEP_ALIVE_S = 5;
  private static final int MAX_IN_FLIGHT = 4_096;
  private static final int RECONNECT_AT_MOST_EVERY_MS = 2_000;

  private final String address;
  private final String systemId;
  private final MessageCodec codec;
  private final Receiver receiver;
  private final MqttAsyncClient client;
  private final Map<String, Channel<?>> subscribed = new ConcurrentHashMap<>();
  private final Map<String, Map<List<String>, String>> topics = new ConcurrentHashMap<>();
  private final String instance = UUID.randomUUID().toString();
  private final AtomicLong refused = new AtomicLong();
  private volatile boolean closed;

  MqttConnection(
      String address, String systemId, String serviceName, MessageCodec codec, Receiver receiver) {
    this.address = address;
    this.systemId = systemId;
    this.codec = codec;
    this.receiver = receiver;
    try {
      // Brokers drop the older of two clients with one ID, so a restarted service must not take its
      // predecessor's.
      String clientId = systemId + "/" + serviceName + "/" + instance;
      client = new MqttAsyncClient(address, clientId, new MemoryPersistence());
    } catch (MqttException | IllegalArgumentException e) {
      throw new CommunicationException(
          "Communication Manager address " + address + " cannot be used: " + e.getMessage(), e);
    }
    client.setCallback(new Callback());
  }

  void open(BrokerAccess access) {
    MqttConnectOptions options = new MqttConnectOptions();
    options.setCleanSession(true);
    options.setAutomaticReconnect(true);
    options.setMaxReconnectDelay(RECONNECT_AT_MOST_EVERY_MS);
    options.setKeepAliveInterval(KEEP_ALIVE_S);
    options.setSocketFactory(access.sockets());
    access
        .user()
        .ifPresent(
            user -> {
              options.setUserName(user);
              options.setPassword(access.password());
            });
    options.setMaxInflight(MAX_IN_FLIGHT);
    options.setConnectionTimeout((int) (ANSWER_WITHIN_MS / 1_000));
    try {
      client.connect(options).waitForCompletion(ANSWER_WITHIN_MS);
    } catch (MqttException e) {
      close();
      throw new CommunicationException(
          "no Communication Manager at "
              + address
              + ": "
              + reason(e)
              + "; is it running, and is the address right?",
          e);
    }
  }

  @Override
  public String instance() {
    return instance;
  }

  @Override
  public boolean publish(Channel<?> channel, U2SAData message) {
    if (closed || !channel.carries(message) || systemId.equals(Topic.ANY_SYSTEM)) {
      refused.incrementAndGet();
      return false;
    }
    boolean eachMatters = channel.deliversEvery() || channel.isRetained();
    try {
      client.publish(
          topic(channel, message),
          message.serialize(),
          eachMatters ? AT_LEAST_ONCE : AT_MOST_ONCE,
          channel.isRetained());
      return true;
    } catch (MqttException e) {
      countRefused("publishing on \"" + channel + "\" failed: " + reason(e));
      return false;
    } catch (IllegalStateException e) {
      countRefused("publishing on \"" + channel + "\" failed: " + e.getMessage()); // too long
      return false;
    }
  }

  private String topic(Channel<?> channel, U2SAData message) {
    return topics
        .computeIfAbsent(channel.name(), name -> new ConcurrentHashMap<>())
        .computeIfAbsent(
            message.typeChain(), chain -> new Topic(systemId, channel.name(), chain).toString());
  }

  @Override
  public boolean subscribe(Channel<?> channel) {
    subscribed.put(channel.name(), channel);
    return request(channel);
  }

  private boolean request(Channel<?> channel) {
    try {
      client
          .subscribe(Topic.filter(systemId, channel), AT_LEAST_ONCE)
          .waitForCompletion(ANSWER_WITHIN_MS);
      return true;
    } catch (MqttException e) {
      receiver.trouble(
          "subscribing to \"" + channel + "\" at " + address + " failed: " + reason(e));
      return false;
    }
  }

  @Override
  public boolean unsubscribe(Channel<?> channel) {
    subscribed.remove(channel.name());
    try {
      client.unsubscribe(Topic.filter(systemId, channel)).waitForCompletion(ANSWER_WITHIN_MS);
      return true;
    } catch (MqttException e) {
      receiver.trouble(
          "unsubscribing from \"" + channel + "\" at " + address + " failed: " + reason(e));
      return false;
    }
  }

  @Override
  public long refused() {
    return refused.get();
  }

  @Override
  public void close() {
    if (closed) {
      return;
    }
    closed = true;
    try {
      if (client.isConnected()) {
        client
            .disconnect()
            .waitForCompletion(
                ANSWER_WITHIN_MS); // waits for what is in flight, such as neutral commands
      } else {
        client.disconnectForcibly(0, ANSWER_WITHIN_MS, false);
      }
      client.close(true);
    } catch (MqttException e) {
      receiver.trouble("closing the connection to " + address + " failed: " + reason(e));
    }
  }

  private void countRefused(String what) {
    long count = refused.incrementAndGet();
    if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
      receiver.trouble(what + " (" + count + " so far)");
    }
  }

  private static String reason(MqttException e) {
    Throwable cause = e.getCause();
    return cause == null ? e.getMessage() : e.getMessage() + " (" + cause.getMessage() + ")";
  }

  /** Called by Paho on its own threads. */
  private final class Callback implements MqttCallbackExtended {
    @Override
    public void connectComplete(boolean reconnect, String serverUri) {
      if (reconnect) {
        receiver.trouble("connection to " + address + " restored");
        // Waiting for an answer on Paho's callback thread would deadlock, so the answers are not
        // awaited here.
        for (Channel<?> channel : subscribed.values()) {
          try {
            client.subscribe(Topic.filter(systemId, channel), AT_LEAST_ONCE);
          } catch (MqttException e) {
            receiver.trouble("subscribing to \"" + channel + "\" again failed: " + reason(e));
          }
        }
      }
    }

    @Override
    public void connectionLost(Throwable cause) {
      if (!closed) {
        receiver.trouble("connection to " + address + " lost: " + cause.getMessage());
      }
    }

    @Override
    public void messageArrived(String topicName, MqttMessage message) {
      try {
        Topic topic = Topic.parse(topicName);
        Channel<?> channel = subscribed.get(topic.channel());
        if (channel == null) {
          return; // came in while unsubscribing
        }
        U2SAData data = codec.decode(topic.typeChain(), message.getPayload());
        data.freeze();
        if (channel.carries(data)) {
          receiver.receive(channel, data);
        } else {
          countRefused("a message on " + topicName + " is not of type " + channel.type().name());
        }
      } catch (MalformedMessageException | IllegalArgumentException e) {
        countRefused("a message on " + topicName + " cannot be read: " + e.getMessage());
      } catch (RuntimeException e) {
        // Paho would cut the connection.
        countRefused("receiving a message on " + topicName + " failed: " + e);
      }
    }

    @Override
    public void deliveryComplete(IMqttDeliveryToken token) {
      // Nothing waits for a delivery: what was not delivered shows as a lost connection.
    }
  }
}
