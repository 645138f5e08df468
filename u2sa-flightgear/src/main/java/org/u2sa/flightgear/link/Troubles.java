package org.u2sa.flightgear.link;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import org.u2sa.interfaces.time.Clock;

/**
 * Collects link events for the log: each event once, refused lines at most once per {@link
 * #PAUSE_MICROS}. Thread-safe.
 */
final class Troubles {
  static final long PAUSE_MICROS = 5 * Clock.MICROS_PER_SECOND;

  private static final int MAX_KEPT = 20;

  private final Clock clock;
  private final Deque<String> events = new ArrayDeque<>();
  private long refused;
  private long refusedUnsaid;
  private String refusedWhy = "";
  private long refusedSaidMicros = Long.MIN_VALUE / 2;

  Troubles(Clock clock) {
    this.clock = clock;
  }

  synchronized void event(String what) {
    if (events.size() == MAX_KEPT) {
      events.removeFirst(); // events are not read: keep the newest
    }
    events.addLast(what);
  }

  /** Closes a resource; a failure is only reported. */
  void close(Closeable thing) {
    try {
      thing.close();
    } catch (IOException e) {
      event("closing a connection failed: " + e.getMessage());
    }
  }

  synchronized void refusedLine(String why) {
    refused++;
    refusedUnsaid++;
    refusedWhy = why;
  }

  /** Number of lines refused so far. */
  synchronized long refusedLines() {
    return refused;
  }

  /** Unreported events; empty if none. */
  synchronized String take() {
    long now = clock.micros();
    if (refusedUnsaid > 0 && now - refusedSaidMicros >= PAUSE_MICROS) {
      String lines =
          refusedUnsaid == 1
              ? "1 line from FlightGear refused: "
              : refusedUnsaid + " lines from FlightGear refused, the last: ";
      event(lines + refusedWhy);
      refusedUnsaid = 0;
      refusedSaidMicros = now;
    }
    String all = String.join("; ", events);
    events.clear();
    return all;
  }
}
