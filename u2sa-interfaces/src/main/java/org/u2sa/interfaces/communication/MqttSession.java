package org.u2sa.interfaces.communication;

import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.eclipse.paho.client.mqttv3.IMqttActionListener;
import org.eclipse.paho.client.mqttv3.IMqttDeliveryToken;
import org.eclipse.paho.client.mqttv3.IMqttToken;
import org.eclipse.paho.client.mqttv3.MqttAsyncClient;
import org.eclipse.paho.client.mqttv3.MqttCallback;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.eclipse.paho.client.mqttv3.MqttMessage;
import org.eclipse.paho.client.mqttv3.MqttPingSender;
import org.eclipse.paho.client.mqttv3.internal.ClientComms;
import org.eclipse.paho.client.mqttv3.persist.MemoryPersistence;

/**
 * One MQTT session, from its opening until it breaks or is closed: a Paho client that is used once,
 * so that nothing of a broken link comes back later. Counts the unconfirmed messages.
 */
final class MqttSession {
  private static final int AT_MOST_ONCE = 0;
  private static final int AT_LEAST_ONCE = 1;
  private static final int REFUSED = 0x80; // in the broker's answer to a subscription
  private static final int OWED_AT_MOST = 4_096;
  private static final long FAREWELL_WITHIN_MS = 1_000;
  private static final long OVER = Long.MIN_VALUE / 2;

  private final MqttAsyncClient client;
  private final MqttConnection owner;
  private final long answerWithinMs;
  private final AtomicLong owed = new AtomicLong(); // far below zero: the session is over
  private final Set<String> asked = ConcurrentHashMap.newKeySet(); // filters that it answered
  private final CountDownLatch settled = new CountDownLatch(1);
  private volatile boolean closing;
  private boolean gone; // Paho's client is closed; guarded by this

  /** Takes what a session needs; {@link #open} begins it. */
  MqttSession(
      String address,
      String clientId,
      ScheduledExecutorService linkThread,
      long answerWithinMs,
      MqttConnection owner)
      throws MqttException {
    this.owner = owner;
    this.answerWithinMs = answerWithinMs;
    client =
        new MqttAsyncClient(
            address, clientId, new MemoryPersistence(), new KeepAlive(linkThread), null);
    client.setCallback(new Callback());
  }

  /**
   * Begins the session. Called on a daemon thread, from which Paho's threads inherit that they do
   * not keep the program alive.
   *
   * @throws MqttException if the broker does not answer, or refuses
   */
  void open(MqttConnectOptions options) throws MqttException {
    options.setMaxInflight(2 * OWED_AT_MOST); // the bound is held here
    client.connect(options).waitForCompletion(answerWithinMs);
  }

  /**
   * Sends a message.
   *
   * @param eachMatters whether the broker is to confirm it
   * @param delivered told when the broker has confirmed it; null if nobody wants to know
   * @return whether it was taken; otherwise the session is over, or owes too many already
   * @throws MqttException if it cannot be sent
   * @throws IllegalStateException if it is too long
   */
  boolean publish(
      String topic,
      byte[] payload,
      boolean eachMatters,
      boolean retained,
      IMqttActionListener delivered)
      throws MqttException {
    long owing = owed.incrementAndGet();
    boolean sent = false;
    try {
      if (owing > 0 && owing <= OWED_AT_MOST) {
        int quality = eachMatters ? AT_LEAST_ONCE : AT_MOST_ONCE;
        client.publish(topic, payload, quality, retained, null, delivered);
        sent = true;
      }
    } finally {
      if (!sent) {
        owed.decrementAndGet();
      }
    }
    return sent;
  }

  /**
   * Asks for messages and waits for the broker's answer.
   *
   * @return the filters that it refused; empty if it consented to all
   * @throws MqttException if it does not answer
   */
  Set<String> subscribe(boolean eachMatters, String... filters) throws MqttException {
    int[] qualities = new int[filters.length];
    Arrays.fill(qualities, eachMatters ? AT_LEAST_ONCE : AT_MOST_ONCE);
    IMqttToken answer = client.subscribe(filters, qualities);
    answer.waitForCompletion(answerWithinMs);
    int[] granted = answer.getGrantedQos();
    Set<String> refused = new LinkedHashSet<>();
    for (int i = 0; i < filters.length; i++) {
      if (i >= granted.length || granted[i] == REFUSED) {
        refused.add(filters[i]);
      }
    }
    asked.addAll(Arrays.asList(filters));
    return refused;
  }

  /** Whether the broker has answered {@link #subscribe} with this filter, either way. */
  boolean hasAsked(String filter) {
    return asked.contains(filter);
  }

  /** Ends {@link #subscribe}. */
  void unsubscribe(String... filters) throws MqttException {
    Arrays.asList(filters).forEach(asked::remove);
    client.unsubscribe(filters).waitForCompletion(answerWithinMs);
  }

  /** Whether the session broke or was ended. */
  boolean isOver() {
    return owed.get() < 0;
  }

  /**
   * Disconnects after the messages on their way, such as neutral commands, were sent and, where
   * each matters, confirmed. Paho alone would send its DISCONNECT before waiting messages.
   *
   * @return how many messages may not have arrived
   */
  long close() {
    closing = true;
    if (owed.get() == 0) {
      settled.countDown();
    }
    try {
      settled.await(answerWithinMs, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // ends at once, then
    }
    long lost = end();
    try {
      client.disconnect(FAREWELL_WITHIN_MS).waitForCompletion(FAREWELL_WITHIN_MS);
    } catch (MqttException e) {
      return lost + cut(); // it broke meanwhile
    }
    abandon();
    return lost;
  }

  /** Cuts the link, but leaves the client open to Paho's threads, which may be closing it. */
  private synchronized long cut() {
    long lost = end();
    if (gone) {
      return lost; // Paho has nothing left to disconnect, and would trip over it
    }
    try {
      client.disconnectForcibly(0, 0, false);
    } catch (MqttException e) {
      return lost; // Paho was faster
    }
    return lost;
  }

  /** Cuts the session off without a DISCONNECT. Safe on one that was never open. */
  synchronized long abandon() {
    long lost = cut();
    if (gone) {
      return lost;
    }
    gone = true;
    try {
      client.close(true);
    } catch (MqttException e) {
      return lost; // Paho is closing it already
    }
    return lost;
  }

  /** Stops counting; returns how many messages were unconfirmed. */
  long end() {
    return Math.max(0, owed.getAndSet(OVER));
  }

  private final class Callback implements MqttCallback {
    @Override
    public void connectionLost(Throwable cause) {
      owner.lost(MqttSession.this, reason(cause));
    }

    @Override
    public void messageArrived(String topicName, MqttMessage message) {
      owner.arrived(topicName, message.getPayload(), message.isRetained());
    }

    @Override
    public void deliveryComplete(IMqttDeliveryToken token) {
      if (owed.decrementAndGet() == 0 && closing) {
        settled.countDown();
      }
    }
  }

  /** Paho's message and that of its cause. */
  static String reason(Throwable e) {
    Throwable cause = e.getCause();
    return cause == null ? e.getMessage() : e.getMessage() + " (" + cause.getMessage() + ")";
  }

  /**
   * Has Paho look after the link at regular times, on the connection's own thread. Paho's own
   * senders keep the program alive, or interrupt the thread that found the link dead.
   */
  private static final class KeepAlive implements MqttPingSender {
    private final ScheduledExecutorService thread;
    private ClientComms link;
    private Future<?> next;
    private boolean stopped;

    KeepAlive(ScheduledExecutorService thread) {
      this.thread = thread;
    }

    @Override
    public synchronized void init(ClientComms comms) {
      link = comms;
    }

    @Override
    public void start() {
      schedule(link.getKeepAlive());
    }

    @Override
    public synchronized void stop() {
      stopped = true;
      if (next != null) {
        next.cancel(false);
      }
    }

    @Override
    public synchronized void schedule(long delayMs) {
      if (stopped) {
        return;
      }
      try {
        next = thread.schedule((Runnable) link::checkForActivity, delayMs, TimeUnit.MILLISECONDS);
      } catch (RejectedExecutionException e) {
        stopped = true; // the connection is being closed, and its thread with it
      }
    }
  }
}
