package org.u2sa.drivers.ioio;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;

/**
 * Maintains the board connection: connects, detects loss or silence, reconnects. Blocking work runs
 * on a daemon thread in real time, and in {@link #step} in lockstep. All methods belong to the
 * service's thread; only closing blocks.
 */
final class BoardConnector implements AutoCloseable {
  private static final long RETRY_MS = 250;
  private static final long RETRY_MICROS = 1000 * RETRY_MS;
  private static final long ANSWER_WITHIN_MICROS = 3_000_000;
  private static final long END_WITHIN_MS = 1_000;
  private static final long ASK_EVERY_MS = 250;
  private static final int ASKED_PER_PATIENCE = 4;
  private static final long LONGEST_LOOK_MICROS = 100_000; // longer means that this process paused

  private final BoardConnection connection;
  private final PinPlan plan;
  private final long silentMicros;
  private final Thread connector = new Thread(this::connect, "u2sa-ioio-connector");
  private final Object lock = new Object(); // guards the connector's waits
  private volatile boolean closed;
  private volatile BoardSession attempt; // current attempt, connected or not; null in between
  private volatile BoardSession session; // current connection, or null
  private volatile String trouble = "";
  private BoardSession watched; // session of the last sign of life
  private long seenBytes;
  private long seenMicros;
  private long seenAnswers;
  private long lookedMicros; // when it last looked for answers
  private long deafMicros; // time watched without an answer
  private long retryMicros = Long.MIN_VALUE;

  /**
   * Idle until {@link #start}.
   *
   * @param silentAfterS time without a byte, or without an answer to a message, after which the
   *     board counts as lost [s]
   */
  BoardConnector(BoardConnection connection, PinPlan plan, double silentAfterS) {
    this.connection = connection;
    this.plan = plan;
    silentMicros = Clock.micros(silentAfterS);
    connector.setDaemon(true);
  }

  /** Starts connecting; in lockstep, {@link #step} connects. */
  void start() {
    if (!connection.isLockstep()) {
      connector.start();
    }
  }

  /** Current connection, if any. */
  Optional<BoardSession> session() {
    return Optional.ofNullable(session).filter(BoardSession::isUp);
  }

  /** Reason the board is absent; empty if connected or not tried yet. */
  String trouble() {
    return trouble;
  }

  /** Supervises the connection; in lockstep, advances the board to now [µs]. */
  void step(long nowMicros) {
    if (connection.isLockstep()) {
      stepInLockstep(nowMicros);
    }
    watch(nowMicros);
  }

  private void stepInLockstep(long nowMicros) {
    BoardSession before = session;
    connection.exchange(nowMicros, bytes -> take(before, bytes));
    if (before != null && !before.isUp()) {
      awaitEnd(before);
    }
    if (session == null && nowMicros >= retryMicros) {
      retryMicros = nowMicros + RETRY_MICROS;
      Thread once = new Thread(this::triedOnce, "u2sa-ioio-connector");
      once.setDaemon(true); // inherited by the library's threads
      once.start();
      join(once, Long.MAX_VALUE);
    }
  }

  private static void take(BoardSession from, byte[] bytes) {
    if (from != null) { // may be null if waiting for its end was interrupted
      from.take(bytes);
    }
  }

  private void connect() {
    try {
      while (!closed) {
        BoardSession made = triedOnce();
        if (made != null) {
          awaitEnd(made);
        }
        synchronized (lock) {
          if (!closed) {
            lock.wait(RETRY_MS);
          }
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Like {@link #tryOnce}, but prevents a library fault from ending reconnection. */
  private BoardSession triedOnce() {
    try {
      return tryOnce();
    } catch (RuntimeException e) {
      trouble = e.toString();
      attempt = null;
      return null;
    }
  }

  /** Returns the connection, or null on failure. */
  private BoardSession tryOnce() {
    BoardSession made = new BoardSession(connection, askEveryMs());
    attempt = made;
    String reason = closed ? "closed" : made.connect(plan);
    if (!reason.isEmpty()) {
      trouble = reason;
      attempt = null;
      return null;
    }
    trouble = "";
    session = made;
    if (closed) {
      made.disconnect(); // closed in the meantime; nobody else holds this connection
    }
    return made;
  }

  private long askEveryMs() {
    return Math.min(ASK_EVERY_MS, silentMicros / (ASKED_PER_PATIENCE * 1000L));
  }

  private void awaitEnd(BoardSession made) {
    try {
      trouble = made.awaitEnd();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    session = null;
    attempt = null;
  }

  /** Gives up a board that does not answer, has fallen silent, or no longer accepts data. */
  private void watch(long nowMicros) {
    BoardSession present = attempt;
    if (present == null || !present.link().isHandshaking() || !present.isUp()) {
      watched = null;
      return;
    }
    boolean isConnected = present == session;
    if (present != watched) {
      deafMicros = 0;
    }
    long bytes = present.link().received();
    if (present != watched || isConnected && bytes != seenBytes) {
      watched = present;
      seenBytes = bytes;
      seenMicros = nowMicros;
    }
    if (isDeaf(present, isConnected, nowMicros)) {
      giveUp(
          present,
          "it sends, but has not obeyed for more than " + Clock.seconds(silentMicros) + " s");
      return;
    }
    long patience = isConnected ? silentMicros : ANSWER_WITHIN_MICROS;
    if (nowMicros - seenMicros > patience) {
      String what = isConnected ? "no data for more than " : "no answer within ";
      giveUp(present, what + Clock.seconds(patience) + " s");
    }
  }

  /** Whether a connected board has not answered for too long, regardless of what else it sends. */
  private boolean isDeaf(BoardSession present, boolean isConnected, long nowMicros) {
    long answers = present.answers().orElse(0);
    if (present.answers().isEmpty() || !isConnected || answers != seenAnswers) {
      deafMicros = 0;
    } else {
      deafMicros += Math.min(Math.max(0, nowMicros - lookedMicros), LONGEST_LOOK_MICROS);
    }
    seenAnswers = answers;
    lookedMicros = nowMicros;
    return deafMicros > silentMicros;
  }

  /** Gives up a connection; closes it on another thread, because closing may block on the link. */
  void giveUp(BoardSession lost, String reason) {
    lost.giveUp(reason);
    Thread closer = new Thread(lost::disconnect, "u2sa-ioio-closer");
    closer.setDaemon(true);
    closer.start();
  }

  private static void join(Thread thread, long atMostMs) {
    try {
      if (atMostMs == Long.MAX_VALUE) {
        thread.join();
      } else {
        thread.join(atMostMs);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Closes the connection after flushing pending data. */
  @Override
  public void close() {
    closed = true;
    BoardSession last = attempt;
    synchronized (lock) {
      lock.notifyAll();
    }
    if (last != null) {
      last.disconnect();
    }
    if (connection.isLockstep()) {
      if (last != null) {
        awaitEnd(last);
      }
    } else {
      join(connector, END_WITHIN_MS);
    }
  }
}
