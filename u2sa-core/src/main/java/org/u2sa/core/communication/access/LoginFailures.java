package org.u2sa.core.communication.access;

import java.util.Map;
import org.u2sa.core.communication.limit.RecentlyUsed;
import org.u2sa.interfaces.time.Clock;

/** Counts wrong passwords by name and address. Thread-safe. */
public final class LoginFailures {
  private static final int REMEMBERED = 4_096;
  private static final long FIRST_WAIT_MICROS = 250_000;
  private static final long LONGEST_WAIT_MICROS = 30 * Clock.MICROS_PER_SECOND;
  private static final long FORGOTTEN_AFTER_MICROS = 600 * Clock.MICROS_PER_SECOND;
  private static final int DOUBLINGS = 20; // exceeds the longest wait, without overflow

  private record Failures(int count, long lastMicros) {}

  private final Clock clock;
  private final Map<String, Failures> byKey =
      new RecentlyUsed<>(REMEMBERED); // both guarded by this
  private final Map<String, Failures> byAddress = new RecentlyUsed<>(REMEMBERED);

  /** No failures yet. */
  public LoginFailures(Clock clock) {
    this.clock = clock;
  }

  /** Counts a wrong password. */
  public synchronized void add(LoginApplication wrong) {
    byKey.put(wrong.key(), oneMore(byKey, wrong.key()));
    byAddress.put(wrong.from(), oneMore(byAddress, wrong.from()));
  }

  private Failures oneMore(Map<String, Failures> map, String key) {
    return new Failures(recent(map, key) + 1, clock.micros());
  }

  private int recent(Map<String, Failures> map, String key) {
    Failures before = map.get(key);
    boolean counts = before != null && clock.micros() - before.lastMicros < FORGOTTEN_AFTER_MICROS;
    return counts ? before.count : 0;
  }

  /** Resets the count of the name from the address; the address's own count remains. */
  public synchronized void forget(LoginApplication right) {
    byKey.remove(right.key());
  }

  /** Whether the name from the address is still in back-off after a wrong password. */
  public synchronized boolean mustWait(LoginApplication application) {
    int count = recent(byKey, application.key());
    if (count == 0) {
      return false;
    }
    long wait = Math.min(FIRST_WAIT_MICROS << Math.min(count - 1, DOUBLINGS), LONGEST_WAIT_MICROS);
    return clock.micros() < byKey.get(application.key()).lastMicros + wait;
  }

  /** Number of recent wrong passwords from the address. */
  public synchronized int from(LoginApplication application) {
    return recent(byAddress, application.from());
  }
}
