package org.u2sa.interfaces.mqtt;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Topic;

/**
 * Retained messages of a connection: the last published on each topic, for brokers that lost them,
 * and the last received, so that a renewed subscription delivers no message twice. Thread-safe.
 */
final class RetainedTopics {
  private static final long ANSWER_WITHIN_MS = 300;
  private static final int MAX_ASKED_AT_ONCE = 64; // brokers limit the filters of a client
  private static final int MAX_BYTES_ASKED_AT_ONCE = 6 * 1_024; // and the length of a packet
  private static final int MAX_UTF8_BYTES_PER_CHAR = 3;

  private final Map<String, Published> published = new ConcurrentHashMap<>();
  private final ReceivedMessages received = new ReceivedMessages();
  private final Set<String> knownBefore = ConcurrentHashMap.newKeySet();
  private volatile Inquiry inquiry; // null unless the broker is being queried

  private final Consumer<String> refuse;

  /**
   * @param refuse notified of messages that cannot be sent at all
   */
  RetainedTopics(Consumer<String> refuse) {
    this.refuse = refuse;
  }

  static final class Published {
    private final byte[] payload;
    private volatile boolean confirmed;
    private volatile MqttSession
        settled; // latest session whose broker holds this or a newer message

    private Published(byte[] payload) {
      this.payload = payload;
    }

    /** Marks the message as stored by the session's broker, or no longer needed there. */
    void settle(MqttSession session) {
      settled = session;
    }

    void confirm() {
      confirmed = true;
    }
  }

  private record Inquiry(Set<String> unanswered, CountDownLatch answers) {
    boolean answered(String topic) {
      boolean awaited = unanswered.remove(topic);
      if (awaited) {
        answers.countDown();
      }
      return awaited;
    }
  }

  /** Registers a message before publication. */
  Published publishing(String topic, byte[] payload) {
    Published last = new Published(payload);
    published.put(topic, last);
    return last;
  }

  /**
   * Registers a received message; returns whether it is new. The first on a topic in a session may
   * repeat the last one of the previous session.
   */
  boolean isNews(String topic, byte[] payload) {
    Inquiry asked = inquiry;
    boolean answer =
        asked != null && asked.answered(topic); // will be delivered again by the subscription
    boolean first = answer ? knownBefore.contains(topic) : knownBefore.remove(topic);
    byte[] before = received.put(topic, payload);
    return !(first && Arrays.equals(before, payload));
  }

  /** Forgets the messages received on a channel, so that a new subscription delivers them again. */
  void forget(Channel<?> channel) {
    received.forget(topic -> Topic.parse(topic).channel().equals(channel.name()));
  }

  /**
   * Republishes messages that a new session's broker lacks or may not have received, unless another
   * connection has published since. The session is not in use yet.
   */
  void restore(MqttSession session) throws MqttException, InterruptedException {
    knownBefore.clear();
    knownBefore.addAll(received.topics());
    Map<String, Published> mine = new LinkedHashMap<>(published);
    if (mine.isEmpty()) {
      return;
    }
    Set<String> lacking = notHeld(session, mine.keySet());
    for (Map.Entry<String, Published> each : mine.entrySet()) {
      Published last = each.getValue();
      if (lacking.contains(each.getKey()) || !last.confirmed) {
        publish(session, each.getKey(), last);
      } else {
        last.settle(session);
      }
    }
  }

  /** Queries the broker; topics it does not let us subscribe to count as held. */
  private Set<String> notHeld(MqttSession session, Set<String> asked)
      throws MqttException, InterruptedException {
    Set<String> lacking = new HashSet<>();
    List<String> part = new ArrayList<>();
    int bytes = 0;
    for (String topic : asked) {
      int its = MAX_UTF8_BYTES_PER_CHAR * topic.length();
      if (part.size() == MAX_ASKED_AT_ONCE || bytes + its > MAX_BYTES_ASKED_AT_ONCE) {
        lacking.addAll(notHeld(session, part));
        part.clear();
        bytes = 0;
      }
      part.add(topic);
      bytes += its;
    }
    lacking.addAll(notHeld(session, part));
    return lacking;
  }

  private Set<String> notHeld(MqttSession session, List<String> asked)
      throws MqttException, InterruptedException {
    Set<String> lacking = ConcurrentHashMap.newKeySet();
    lacking.addAll(asked);
    String[] topics = asked.toArray(new String[0]);
    CountDownLatch answers = new CountDownLatch(topics.length);
    Inquiry asking = new Inquiry(lacking, answers);
    inquiry = asking;
    try {
      session.subscribe(false, topics).forEach(asking::answered);
      answers.await(ANSWER_WITHIN_MS, TimeUnit.MILLISECONDS);
      session.unsubscribe(topics);
    } finally {
      inquiry = null;
    }
    return lacking;
  }

  /**
   * Publishes the messages missing in the current session: published while it was created, or
   * rejected when sent.
   *
   * @param lockOf lock held while publishing on a topic, so that no message overtakes a newer one
   * @return whether the session now has everything
   */
  boolean catchUp(MqttSession session, Function<String, ?> lockOf) throws MqttException {
    boolean all = true;
    for (String topic : published.keySet()) {
      synchronized (lockOf.apply(topic)) {
        Published last = published.get(topic);
        if (last != null && last.settled != session) {
          all &= publish(session, topic, last);
        }
      }
    }
    return all;
  }

  /** Returns false if the session cannot accept it now. */
  private boolean publish(MqttSession session, String topic, Published last) throws MqttException {
    try {
      if (!session.publish(topic, last.payload, true, true, last::confirm)) {
        return false;
      }
      last.settle(session);
    } catch (IllegalStateException e) { // too long: retrying is pointless
      published.remove(topic, last);
      refuse.accept("publishing on " + topic + " failed: " + MqttSession.reason(e));
    }
    return true;
  }
}
