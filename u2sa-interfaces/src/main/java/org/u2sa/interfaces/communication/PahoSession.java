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

/** A session by a Paho client that is used once. */
final class PahoSession implements MqttSession {
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
  PahoSession(
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

  /** Called on a daemon thread: Paho's threads inherit that they do not keep the program alive. */
  @Override
  public void open(MqttConnectOptions options) throws MqttException {
    options.setMaxInflight(2 * OWED_AT_MOST); // the bound is held here
    client.connect(options).waitForCompletion(answerWithinMs);
  }

  @Override
  public boolean publish(
      String topic, byte[] payload, boolean eachMatters, boolean retained, Runnable confirmed)
      throws MqttException {
    long owing = owed.incrementAndGet();
    boolean sent = false;
    try {
      if (owing > 0 && owing <= OWED_AT_MOST) {
        int quality = eachMatters ? AT_LEAST_ONCE : AT_MOST_ONCE;
        client.publish(
            topic,
            payload,
            quality,
            retained,
            null,
            confirmed == null ? null : new Delivery(confirmed));
        sent = true;
      }
    } finally {
      if (!sent) {
        owed.decrementAndGet();
      }
    }
    return sent;
  }

  @Override
  public Set<String> subscribe(boolean eachMatters, String... filters) throws MqttException {
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

  @Override
  public boolean hasAsked(String filter) {
    return asked.contains(filter);
  }

  @Override
  public void unsubscribe(String... filters) throws MqttException {
    Arrays.asList(filters).forEach(asked::remove);
    client.unsubscribe(filters).waitForCompletion(answerWithinMs);
  }

  @Override
  public boolean isOver() {
    return owed.get() < 0;
  }

  /** Paho alone would send its DISCONNECT before waiting messages. */
  @Override
  public long close() {
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

  @Override
  public synchronized long abandon() {
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

  @Override
  public long end() {
    return Math.max(0, owed.getAndSet(OVER));
  }

  private final class Callback implements MqttCallback {
    @Override
    public void connectionLost(Throwable cause) {
      owner.lost(PahoSession.this, MqttSession.reason(cause));
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

  private record Delivery(Runnable confirmed) implements IMqttActionListener {
    @Override
    public void onSuccess(IMqttToken token) {
      confirmed.run();
    }

    @Override
    public void onFailure(IMqttToken token, Throwable error) {
      // it stays unconfirmed
    }
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
