package org.u2sa.interfaces.mqtt;

import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.u2sa.interfaces.time.Clock;

/**
 * Maintains a connection's link to the broker on a daemon thread: creates a new session when one
 * breaks, and declares it open only after all subscriptions are confirmed, which Paho's automatic
 * reconnect does not.
 */
final class MqttLink {
  private static final long ANSWER_WITHIN_MS = 4_000;
  private static final long IF_BUSY_MICROS = 60 * Clock.MICROS_PER_SECOND;
  private static final long END_WITHIN_MS = 1_000;
  private static final long CATCH_UP_AFTER_MS = 100;

  private final String address;
  private final String clientId;
  private final MqttConnection owner;
  private final MqttClient client;
  private final ScheduledThreadPoolExecutor linkThread;
  private volatile Supplier<MqttConnectOptions> options;
  private volatile Clock clock;
  private volatile BackOff backOff;
  private final AtomicReference<MqttSession> current = new AtomicReference<>();
  private final AtomicBoolean catchesUp = new AtomicBoolean();
  private volatile boolean closed;
  private volatile MqttSession opened; // latest session, possibly not in use yet
  private String lastFailure = ""; // used by the link thread only
  private long lostAtMicros; // used by the link thread only

  MqttLink(String address, String clientId, MqttConnection owner, MqttClient client) {
    this.client = client;
    this.address = address;
    this.clientId = clientId;
    this.owner = owner;
    linkThread =
        new ScheduledThreadPoolExecutor(
            1,
            task -> {
              Thread thread = new Thread(task, "u2sa-link " + clientId);
              thread.setDaemon(true);
              return thread;
            });
    linkThread.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    linkThread.setRemoveOnCancelPolicy(true);
  }

  /**
   * Connects for the first time.
   *
   * @param how session settings; evaluated for each attempt
   * @param patienceMicros time limit for all attempts
   * @throws MqttException if the broker is unreachable within that time
   */
  void open(Supplier<MqttConnectOptions> how, long patienceMicros, Clock time, Random random)
      throws MqttException {
    options = how;
    clock = time;
    backOff = new BackOff(random);
    long begun = clock.micros();
    long waitMs = 0;
    while (true) {
      try {
        linkThread.schedule(this::connectOnce, waitMs, TimeUnit.MILLISECONDS).get();
        return;
      } catch (ExecutionException e) {
        if (!(e.getCause() instanceof MqttException failure)) {
          throw new IllegalStateException(e.getCause());
        }
        waitMs = backOff.nextMs();
        // "Server unavailable" means the broker is up but busy: retry.
        boolean isBusy = failure.getReasonCode() == MqttException.REASON_CODE_BROKER_UNAVAILABLE;
        long deadline =
            begun + (isBusy ? Math.max(patienceMicros, IF_BUSY_MICROS) : patienceMicros);
        if (isRefusal(failure)
            || clock.micros() + TimeUnit.MILLISECONDS.toMicros(waitMs) > deadline) {
          throw failure;
        }
      } catch (CancellationException | RejectedExecutionException e) {
        throw new MqttException(
            MqttException.REASON_CODE_CLIENT_CLOSED, e); // closed in the meantime
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new MqttException(e);
      }
    }
  }

  /**
   * Whether the broker rejects us permanently. "Bad user name or password" does not count without
   * credentials, because a starting embedded broker answers so.
   */
  private boolean isRefusal(MqttException failure) {
    int code = failure.getReasonCode();
    return code == MqttException.REASON_CODE_NOT_AUTHORIZED
        || code == MqttException.REASON_CODE_FAILED_AUTHENTICATION
            && options.get().getUserName() != null;
  }

  /** Creates a session if none exists; returns whether it did. */
  private boolean connectOnce() throws MqttException, InterruptedException {
    if (closed || current.get() != null) {
      return false;
    }
    MqttSession session =
        client.session(address, clientId, linkThread, ANSWER_WITHIN_MS, owner, clock);
    boolean open = false;
    try {
      session.open(options.get());
      opened = session;
      if (closed) {
        return false;
      }
      owner.renew(session);
      current.set(session);
      catchUp(session); // sends requests made since it was restored
      if (session.isOver()) { // it may have ended before it was current, without notification
        throw new MqttException(MqttException.REASON_CODE_CONNECTION_LOST);
      }
      open = true;
    } finally {
      if (!open || closed) {
        current.compareAndSet(session, null);
        owner.unconfirmed(session.abandon());
      }
    }
    backOff.reset();
    return true;
  }

  /** Schedules a catch-up on the current session. Thread-safe. */
  void catchUpSoon() {
    if (!catchesUp.getAndSet(true)) {
      onLinkThread(
          () -> {
            catchesUp.set(false); // cleared first: later requests need another catch-up
            MqttSession session = current.get();
            if (session != null) {
              catchUpOrLeaveIt(session);
            }
          },
          CATCH_UP_AFTER_MS);
    }
  }

  private void catchUp(MqttSession session) throws MqttException {
    if (!owner.catchUp(session)) {
      catchUpSoon();
    }
  }

  private void catchUpOrLeaveIt(MqttSession session) {
    try {
      catchUp(session);
    } catch (MqttException e) {
      if (!session.isOver()) { // otherwise the next session starts with it
        owner.trouble("catching up at " + address + " failed: " + MqttSession.reason(e));
        catchUpSoon();
      }
    }
  }

  MqttSession session() {
    return current.get();
  }

  /** Starts reconnecting. Called on the session's threads. */
  void lost(MqttSession session, String why) {
    owner.unconfirmed(session.end());
    if (!current.compareAndSet(session, null) || closed) {
      return; // closed, or not in use yet, in which case the opener notices
    }
    try {
      owner.interrupted("connection to " + address + " lost: " + why);
    } finally { // even if the report throws
      onLinkThread(
          () -> {
            lostAtMicros = clock.micros();
            lastFailure = "";
            connectAgain();
          },
          backOff.nextMs());
    }
  }

  private void connectAgain() {
    boolean again = true;
    try {
      if (connectOnce()) {
        owner.restored(Clock.seconds(clock.micros() - lostAtMicros));
      }
      again = false;
    } catch (MqttException e) {
      noWayBack(MqttSession.reason(e));
    } catch (InterruptedException e) {
      again = false;
      Thread.currentThread().interrupt(); // closed
    } catch (RuntimeException e) {
      noWayBack(e.toString());
    } finally {
      if (again) {
        onLinkThread(this::connectAgain, backOff.nextMs());
      }
    }
  }

  private void noWayBack(String failure) {
    if (!failure.equals(lastFailure) && !closed) {
      lastFailure = failure; // reported once
      owner.trouble("cannot reconnect to " + address + " yet: " + failure + "; still trying");
    }
  }

  private void onLinkThread(Runnable task, long delayMs) {
    try {
      linkThread.schedule(task, delayMs, TimeUnit.MILLISECONDS);
    } catch (RejectedExecutionException e) {
      current.set(null); // closed in the meantime
    }
  }

  /**
   * Ends the session after pending messages are sent, and stops all attempts. A running attempt is
   * not interrupted, because Paho would leak threads.
   */
  void close() {
    closed = true;
    MqttSession session = current.getAndSet(null);
    if (session != null) {
      owner.unconfirmed(session.close());
    }
    linkThread.shutdown();
    MqttSession beginning = opened;
    if (beginning != null && beginning != session) {
      owner.unconfirmed(beginning.abandon());
    }
    try {
      linkThread.awaitTermination(END_WITHIN_MS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Exponential back-off with jitter, so that a vehicle's services do not all hit a restarted
   * broker at once.
   */
  static final class BackOff {
    private static final long FIRST_MS = 100;
    private static final long LONGEST_MS = 2_000;
    private static final double MIN_PART = 0.5;

    private final Random random;
    private long nextMs = FIRST_MS;

    BackOff(Random random) {
      this.random = random;
    }

    /** Wait before the next attempt [ms]: random between half and all of a value that doubles. */
    synchronized long nextMs() {
      long whole = nextMs;
      nextMs = Math.min(LONGEST_MS, 2 * nextMs);
      return Math.round(whole * (MIN_PART + (1 - MIN_PART) * random.nextDouble()));
    }

    synchronized void reset() {
      nextMs = FIRST_MS;
    }
  }
}
