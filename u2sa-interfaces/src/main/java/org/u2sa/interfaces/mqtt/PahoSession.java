package org.u2sa.interfaces.mqtt;

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

/** A session using a single-use Paho client. */
final class PahoSession implements MqttSession {
  private static final int AT_MOST_ONCE = 0;
  private static final int AT_LEAST_ONCE = 1;
  private static final int REFUSED = 0x80; // SUBACK failure code
  private static final int OWED_AT_MOST = 4_096;
  private static final long FAREWELL_WITHIN_MS = 1_000;
  private static final long OVER = Long.MIN_VALUE / 2;

  private final MqttAsyncClient client;
  private final Owner owner;
  private final long answerWithinMs;
  private final AtomicLong owed = new AtomicLong(); // far below zero once the session is over
  private final Set<String> asked = ConcurrentHashMap.newKeySet(); // answered filters
  private final CountDownLatch settled = new CountDownLatch(1);
  private volatile boolean closing;
  private boolean gone; // Paho client closed; guarded by this

  PahoSession(
      String address,
      String clientId,
      ScheduledExecutorService linkThread,
      long answerWithinMs,
      Owner owner)
      throws MqttException {
    this.owner = owner;
    this.answerWithinMs = answerWithinMs;
    client =
        new MqttAsyncClient(
            address, clientId, new MemoryPersistence(), new KeepAlive(linkThread), null);
    client.setCallback(new Callback());
  }

  /** Called on a daemon thread, so that Paho's threads inherit daemon status. */
  @Override
  public void open(MqttConnectOptions options) throws MqttException {
    options.setMaxInflight(2 * OWED_AT_MOST); // the limit is enforced here
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

  /** Drains first, because Paho alone would send DISCONNECT before pending messages. */
  @Override
  public long close() {
    closing = true;
    if (owed.get() == 0) {
      settled.countDown();
    }
    try {
      settled.await(answerWithinMs, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // then ends immediately
    }
    long lost = end();
    try {
      client.disconnect(FAREWELL_WITHIN_MS).waitForCompletion(FAREWELL_WITHIN_MS);
    } catch (MqttException e) {
      return lost + cut(); // broken in the meantime
    }
    abandon();
    return lost;
  }

  /** Cuts the link but leaves the client to Paho's threads, which may be closing it. */
  private synchronized long cut() {
    long lost = end();
    if (gone) {
      return lost; // nothing left to disconnect; Paho would fail on it
    }
    try {
      client.disconnectForcibly(0, 0, false);
    } catch (MqttException e) {
      return lost; // already disconnected by Paho
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
      return lost; // already being closed by Paho
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
      // remains unconfirmed
    }
  }

  /**
   * Schedules Paho's keep-alive on the link thread, because Paho's own ping senders keep the JVM
   * alive or interrupt the thread that detected the dead link.
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
        stopped = true; // the connection and its thread are closing
      }
    }
  }
}
