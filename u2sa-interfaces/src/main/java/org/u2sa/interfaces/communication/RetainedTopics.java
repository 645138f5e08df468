package org.u2sa.interfaces.communication;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import org.eclipse.paho.client.mqttv3.MqttException;

/**
 * What one connection knows of retained messages: the last that it published on each topic, so that
 * a broker that lost them gets them again, and the last that came in, so that a renewed
 * subscription does not bring one twice. Safe for several threads.
 */
final class RetainedTopics {
  private static final long ANSWER_WITHIN_MS = 300;

  private final Map<String, Published> published = new ConcurrentHashMap<>();
  private final Map<String, byte[]> received = new ConcurrentHashMap<>();
  private final Set<String> knownBefore = ConcurrentHashMap.newKeySet();
  private volatile Inquiry inquiry; // null unless the broker is being asked what it holds

  private final Consumer<String> refuse;

  /**
   * @param refuse told why a message cannot be sent at all
   */
  RetainedTopics(Consumer<String> refuse) {
    this.refuse = refuse;
  }

  /** One message of this connection, and whether the broker has confirmed it. */
  static final class Published {
    private final byte[] payload;
    private volatile boolean confirmed;
    private volatile MqttSession settled; // the last one whose broker has it or a newer one

    private Published(byte[] payload) {
      this.payload = payload;
    }

    /** Takes note that the session's broker was handed this message, or needs it no more. */
    void settle(MqttSession session) {
      settled = session;
    }

    /** Takes note that the broker has confirmed this message. */
    void confirm() {
      confirmed = true;
    }
  }

  /** Which topics the broker's answer is still awaited for. */
  private record Inquiry(Set<String> unanswered, CountDownLatch answers) {
    boolean answered(String topic) {
      boolean awaited = unanswered.remove(topic);
      if (awaited) {
        answers.countDown();
      }
      return awaited;
    }
  }

  /** Takes note of a message that is about to be published; to be told of its delivery. */
  Published publishing(String topic, byte[] payload) {
    Published last = new Published(payload);
    published.put(topic, last);
    return last;
  }

  /**
   * Takes note of a message that came in. Returns whether it is news: the first on its topic in a
   * session may be the one that came last in the session before.
   */
  boolean isNews(String topic, byte[] payload) {
    Inquiry asked = inquiry;
    boolean answer = asked != null && asked.answered(topic); // the subscription brings it again
    boolean first = answer ? knownBefore.contains(topic) : knownBefore.remove(topic);
    byte[] before = received.put(topic, payload);
    return !(first && Arrays.equals(before, payload));
  }

  /** Forgets what came in on a channel: a subscription that is made anew wants it. */
  void forget(Channel<?> channel) {
    received.keySet().removeIf(topic -> Topic.parse(topic).channel().equals(channel.name()));
  }

  /**
   * Gives the broker of a new session what it lacks of this connection's messages: those that it
   * does not hold, and those of which it is not known that it got them. What another connection
   * published since is left alone.
   *
   * @param session not in use yet, so that nobody else publishes on it
   * @throws MqttException if the broker does not answer
   */
  void restore(MqttSession session) throws MqttException, InterruptedException {
    knownBefore.addAll(received.keySet());
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

  /** Asks the broker; a topic of which it does not let us hear counts as held. */
  private Set<String> notHeld(MqttSession session, Set<String> asked)
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
   * Publishes on a session that is in use what it has not got: messages that were published while
   * the session was being made, or that it could not take when they came.
   *
   * @param lockOf what is held while a message is published on the topic, so that none overtakes a
   *     newer one
   * @return whether the session has everything now
   * @throws MqttException if it breaks
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

  /** Returns false if the session cannot take it now. */
  private boolean publish(MqttSession session, String topic, Published last) throws MqttException {
    try {
      if (!session.publish(topic, last.payload, true, true, last::confirm)) {
        return false;
      }
      last.settle(session);
    } catch (IllegalStateException e) { // too long: no later attempt would succeed
      published.remove(topic, last);
      refuse.accept("publishing on " + topic + " failed: " + MqttSession.reason(e));
    }
    return true;
  }
}
