package org.u2sa.drivers.ioio;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;

/**
 * Keeps a connection to the board: makes it, notices its end or its silence, makes it anew. In real
 * time a daemon thread of its own does what may wait; in lockstep it happens in {@link #step}. All
 * methods belong to the service's thread and wait for nothing but, at the end, the threads.
 */
final class BoardConnector implements AutoCloseable {
  private static final long RETRY_MS = 250;
  private static final long RETRY_MICROS = 1000 * RETRY_MS;
  private static final long ANSWER_WITHIN_MICROS = 3_000_000;
  private static final long END_WITHIN_MS = 1_000;

  private final BoardConnection connection;
  private final PinPlan plan;
  private final long silentMicros;
  private final Thread connector = new Thread(this::connect, "u2sa-ioio-connector");
  private final Object lock = new Object(); // guards the connector's pauses
  private volatile boolean closed;
  private volatile BoardSession attempt; // the present one, connected or not; null between
  private volatile BoardSession session; // the present one if connected, or null
  private volatile String trouble = "";
  private BoardSession watched; // whose sign of life was seen last
  private long seenBytes;
  private long seenMicros;
  private long retryMicros = Long.MIN_VALUE;

  /**
   * Does nothing before {@link #start}.
   *
   * @param silentAfterS time without a byte of the board after which it counts as lost [s]
   */
  BoardConnector(BoardConnection connection, PinPlan plan, double silentAfterS) {
    this.connection = connection;
    this.plan = plan;
    silentMicros = Clock.micros(silentAfterS);
    connector.setDaemon(true);
  }

  /** Begins to connect; in lockstep that happens in {@link #step}. */
  void start() {
    if (!connection.isLockstep()) {
      connector.start();
    }
  }

  /** The connection, if the board is there. */
  Optional<BoardSession> session() {
    return Optional.ofNullable(session).filter(BoardSession::isUp);
  }

  /** Why the board is not there; empty if it is, or was not yet looked for. */
  String trouble() {
    return trouble;
  }

  /** Looks after the connection; in lockstep lets the board's time pass to now [µs]. */
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
      Thread once = new Thread(this::tryOnce, "u2sa-ioio-connector");
      once.setDaemon(true); // and so are the library's threads, which inherit it
      once.start();
      join(once, Long.MAX_VALUE);
    }
  }

  private static void take(BoardSession from, byte[] bytes) {
    if (from != null) { // it is no longer, if the wait for its end was interrupted
      from.take(bytes);
    }
  }

  private void connect() {
    try {
      while (!closed) {
        BoardSession made = tryOnce();
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

  /** Returns the connection, or null if it was not to be had. */
  private BoardSession tryOnce() {
    BoardSession made = new BoardSession(connection);
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
      made.disconnect(); // it was closed meanwhile, and nobody else knows of the connection
    }
    return made;
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

  /** A board that does not answer, or says nothing any more, is lost, even if nobody told. */
  private void watch(long nowMicros) {
    BoardSession present = attempt;
    if (present == null || !present.link().isHandshaking() || !present.isUp()) {
      watched = null;
      return;
    }
    boolean isConnected = present == session;
    long bytes = present.link().received();
    if (present != watched || isConnected && bytes != seenBytes) {
      watched = present;
      seenBytes = bytes;
      seenMicros = nowMicros;
    }
    long patience = isConnected ? silentMicros : ANSWER_WITHIN_MICROS;
    if (nowMicros - seenMicros > patience) {
      String what = isConnected ? "it says nothing for more than " : "no answer within ";
      giveUp(present, what + Clock.seconds(patience) + " s");
    }
  }

  /** Ends a connection for a reason; not on this thread, because closing may wait for the link. */
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

  /** Ends the connection; what was written before goes out. */
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
