package org.u2sa.core.communication;

import java.util.Map;
import org.u2sa.interfaces.time.Clock;

/** A rate limit with bursts, usually of up to a quarter of a second's worth. For one thread. */
final class Allowance {
  private static final double BURST_S = 0.25;
  private static final double LEAST_BURST = 1.0; // even of a slow one

  private final double perS;
  private final double burst;
  private double left;
  private long asOfMicros;

  Allowance(double perS, long nowMicros) {
    this(perS, perS * BURST_S, nowMicros);
  }

  /**
   * @param burst how many may come at once; one at least
   */
  Allowance(double perS, double burst, long nowMicros) {
    this(perS, burst, LEAST_BURST, nowMicros);
  }

  private Allowance(double perS, double burst, double leastBurst, long nowMicros) {
    this.perS = perS;
    this.burst = Math.max(leastBurst, burst);
    left = this.burst;
    asOfMicros = nowMicros;
  }

  /**
   * An allowance of a thread's time.
   *
   * @param part of the time [0…1]
   * @param burstS how much may be taken at once [s]
   */
  static Allowance ofTime(double part, double burstS, long nowMicros) {
    return new Allowance(part, burstS, 0.0, nowMicros);
  }

  /** Whether anything is left; one may overdraw it once. */
  boolean isOpen(long nowMicros) {
    left = Math.min(burst, left + perS * Clock.seconds(nowMicros - asOfMicros));
    asOfMicros = nowMicros;
    return left > 0.0;
  }

  /** To be called after {@link #isOpen}. */
  void take(double amount) {
    left -= amount;
  }

  /** Takes without asking before: what has come cannot be refused. */
  void take(double amount, long nowMicros) {
    isOpen(nowMicros);
    take(amount);
  }

  /**
   * One {@link Allowance} per user, however many connections the user has. Safe for several
   * threads.
   */
  static final class PerUser {
    private static final int USERS_REMEMBERED = 1_024;

    private final double perS;
    private final Map<String, Allowance> byUser = // guarded by this
        new RecentlyUsed<>(USERS_REMEMBERED);

    PerUser(double perS) {
      this.perS = perS;
    }

    /** Takes from the user's allowance if there is any left; it may be overdrawn once. */
    synchronized boolean take(String user, double amount, long nowMicros) {
      Allowance allowance = byUser.computeIfAbsent(user, name -> new Allowance(perS, nowMicros));
      if (!allowance.isOpen(nowMicros)) {
        return false;
      }
      allowance.take(amount);
      return true;
    }

    /** Takes without asking: what was done already. */
    synchronized void charge(String user, double amount, long nowMicros) {
      byUser.computeIfAbsent(user, name -> new Allowance(perS, nowMicros)).take(amount, nowMicros);
    }
  }
}
