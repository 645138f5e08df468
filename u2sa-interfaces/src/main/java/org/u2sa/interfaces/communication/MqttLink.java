package org.u2sa.interfaces.communication;

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
 * Keeps one connection's way to the broker open: makes a new session whenever one breaks, and
 * declares it open only when all that the connection was subscribed to is confirmed again. Paho's
 * own reconnecting would hide what fails then.
 *
 * <p>One daemon thread makes sessions and looks after the link: the link thread.
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
  private volatile MqttSession opened; // the last one, perhaps not in use yet
  private String lastFailure = ""; // touched by the link thread only
  private long lostAtMicros; // touched by the link thread only

  /** A link that {@link #open} makes. */
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
   * @param how settings of a session; asked for at each attempt
   * @param patienceMicros how long to try
   * @throws MqttException if the broker is not there in all that time
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
        // Who is asked to come again comes again: a broker that is only busy is there.
        boolean isBusy = failure.getReasonCode() == MqttException.REASON_CODE_BROKER_UNAVAILABLE;
        long deadline =
            begun + (isBusy ? Math.max(patienceMicros, IF_BUSY_MICROS) : patienceMicros);
        if (isRefusal(failure)
            || clock.micros() + TimeUnit.MILLISECONDS.toMicros(waitMs) > deadline) {
          throw failure;
        }
      } catch (CancellationException | RejectedExecutionException e) {
        throw new MqttException(MqttException.REASON_CODE_CLIENT_CLOSED, e); // closed meanwhile
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new MqttException(e);
      }
    }
  }

  /**
   * Whether the broker does not want us, which waiting does not change. "Bad user name or password"
   * to one who gave none is no answer to us: an embedded broker that is only starting says so.
   */
  private boolean isRefusal(MqttException failure) {
    int code = failure.getReasonCode();
    return code == MqttException.REASON_CODE_NOT_AUTHORIZED
        || code == MqttException.REASON_CODE_FAILED_AUTHENTICATION
            && options.get().getUserName() != null;
  }

  /** Makes a session unless there is one. Returns whether it made one. */
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
      catchUp(session); // with what came since it was renewed
      if (session.isOver()) { // perhaps before it was current, and then nobody was told
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

  /** Lets the owner catch up on the session in use before long. Called from any thread. */
  void catchUpSoon() {
    if (!catchesUp.getAndSet(true)) {
      onLinkThread(
          () -> {
            catchesUp.set(false); // first: what comes from here on wants another one
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
      if (!session.isOver()) { // otherwise the next session begins with it
        owner.trouble("catching up at " + address + " failed: " + MqttSession.reason(e));
        catchUpSoon();
      }
    }
  }

  /** The session in use; null while there is none. */
  MqttSession session() {
    return current.get();
  }

  /**
   * Takes note that a session broke, and begins to make a new one. Called on the session's threads.
   */
  void lost(MqttSession session, String why) {
    owner.unconfirmed(session.end());
    if (!current.compareAndSet(session, null) || closed) {
      return; // closed, or not in use yet: who opens it notices
    }
    owner.interrupted("connection to " + address + " lost: " + why);
    onLinkThread(
        () -> {
          lostAtMicros = clock.micros();
          lastFailure = "";
          connectAgain();
        },
        backOff.nextMs());
  }

  private void connectAgain() {
    try {
      if (connectOnce()) {
        owner.restored(Clock.seconds(clock.micros() - lostAtMicros));
      }
    } catch (MqttException e) {
      String failure = MqttSession.reason(e);
      if (!failure.equals(lastFailure) && !closed) {
        lastFailure = failure; // said once, however long it lasts
        owner.trouble("no way back to " + address + " yet: " + failure + "; tries on");
      }
      onLinkThread(this::connectAgain, backOff.nextMs());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // closed
    }
  }

  private void onLinkThread(Runnable task, long delayMs) {
    try {
      linkThread.schedule(task, delayMs, TimeUnit.MILLISECONDS);
    } catch (RejectedExecutionException e) {
      current.set(null); // closed meanwhile
    }
  }

  /**
   * Ends the session after what is on the way was sent, and with it all attempts. One that is under
   * way is not interrupted before the broker answers or its time is up: Paho, cut off while it
   * begins its threads, leaves them behind.
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
   * How long to wait before the next attempt to connect: longer after each failure, and never the
   * same for all, so that the services of a vehicle do not fall upon a restarted broker together.
   */
  static final class BackOff {
    private static final long FIRST_MS = 100;
    private static final long LONGEST_MS = 2_000;
    private static final double LEAST_PART = 0.5;

    private final Random random;
    private long nextMs = FIRST_MS;

    BackOff(Random random) {
      this.random = random;
    }

    /**
     * The wait before the next attempt [ms]: between half and the whole of what doubles each time.
     */
    synchronized long nextMs() {
      long whole = nextMs;
      nextMs = Math.min(LONGEST_MS, 2 * nextMs);
      return Math.round(whole * (LEAST_PART + (1 - LEAST_PART) * random.nextDouble()));
    }

    /** Begins again with the shortest wait, after success. */
    synchronized void reset() {
      nextMs = FIRST_MS;
    }
  }
}
