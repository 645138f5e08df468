package org.u2sa.core.communication.limit;

import java.util.Map;
import org.u2sa.interfaces.time.Clock;

/**
 * Token bucket: a rate limit with bursts, by default a quarter of a second's worth. Not
 * thread-safe.
 */
public final class Allowance {
  private static final double BURST_S = 0.25;
  private static final double MIN_BURST = 1.0; // even at low rates

  private final double perS;
  private final double burst;
  private double left;
  private long asOfMicros;

  /** Refilled at a rate [1/s]; the burst size is the refill of 0.25 s. */
  public Allowance(double perS, long nowMicros) {
    this(perS, perS * BURST_S, nowMicros);
  }

  /**
   * @param burst burst size; at least one
   */
  public Allowance(double perS, double burst, long nowMicros) {
    this(perS, burst, MIN_BURST, nowMicros);
  }

  private Allowance(double perS, double burst, double leastBurst, long nowMicros) {
    this.perS = perS;
    this.burst = Math.max(leastBurst, burst);
    left = this.burst;
    asOfMicros = nowMicros;
  }

  /**
   * Creates an allowance of a thread's time.
   *
   * @param part share of the time [0…1]
   * @param burstS burst size, as time at the permitted rate [s]
   */
  static Allowance ofTime(double part, double burstS, long nowMicros) {
    return new Allowance(part, burstS, 0.0, nowMicros);
  }

  /** Whether any allowance is left; the next {@link #take} may overdraw it. */
  public boolean isOpen(long nowMicros) {
    left = Math.min(burst, left + perS * Clock.seconds(nowMicros - asOfMicros));
    asOfMicros = nowMicros;
    return left > 0.0;
  }

  /** Takes an amount; call {@link #isOpen} before. */
  public void take(double amount) {
    left -= amount;
  }

  /** Debits unconditionally, for data already received. */
  public void take(double amount, long nowMicros) {
    isOpen(nowMicros);
    take(amount);
  }

  /** One {@link Allowance} per user, shared by all of the user's connections. Thread-safe. */
  public static final class PerUser {
    private static final int USERS_REMEMBERED = 1_024;

    private final double perS;
    private final Map<String, Allowance> byUser = // guarded by this
        new RecentlyUsed<>(USERS_REMEMBERED);

    /** For each user, refilled at a rate [1/s]. */
    public PerUser(double perS) {
      this.perS = perS;
    }

    /** Takes from the user's allowance if any is left; may overdraw it. */
    public synchronized boolean take(String user, double amount, long nowMicros) {
      Allowance allowance = byUser.computeIfAbsent(user, name -> new Allowance(perS, nowMicros));
      if (!allowance.isOpen(nowMicros)) {
        return false;
      }
      allowance.take(amount);
      return true;
    }

    /** Debits unconditionally, for work already done. */
    public synchronized void charge(String user, double amount, long nowMicros) {
      byUser.computeIfAbsent(user, name -> new Allowance(perS, nowMicros)).take(amount, nowMicros);
    }
  }
}
