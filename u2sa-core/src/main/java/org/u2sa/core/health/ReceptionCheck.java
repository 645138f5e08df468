package org.u2sa.core.health;

import org.u2sa.messages.contract.HealthReport;

/**
 * Checks that the monitor receives anything at all. Its own reports take the same route as all
 * others: if they do not return, the connection is broken and the silence of services proves
 * nothing.
 */
final class ReceptionCheck {
  private static final double LOST_AFTER_INTERVALS = 4.0;
  private static final double LOST_AFTER_AT_LEAST_S = 1.0;

  /** Time services need to reconnect: one hanging attempt plus a back-off. */
  private static final double OTHERS_RECONNECT_WITHIN_S = 6.0;

  private double heardS;
  private double lostAfterS = LOST_AFTER_AT_LEAST_S;
  private boolean wasLost;

  ReceptionCheck(double nowS) {
    heardS = nowS;
  }

  /** Handles a report of the monitor itself. */
  void hear(HealthReport own, double nowS) {
    heardS = nowS;
    lostAfterS = Math.max(LOST_AFTER_AT_LEAST_S, LOST_AFTER_INTERVALS * own.interval().orElse(0.0));
  }

  /** Change since the last check. */
  enum Change {
    /** Still receiving. */
    NONE,
    /** Reception has just been lost. */
    LOST,
    /** Still lost. */
    STILL_LOST,
    /** Restored: other services have until {@link #excusedUntilS} to report. */
    RESTORED
  }

  Change look(double nowS) {
    boolean lost = nowS - heardS > lostAfterS;
    boolean before = wasLost;
    wasLost = lost;
    if (lost) {
      return before ? Change.STILL_LOST : Change.LOST;
    }
    return before ? Change.RESTORED : Change.NONE;
  }

  /** Time until which silence is excused after reception was restored. */
  static double excusedUntilS(double nowS) {
    return nowS + OTHERS_RECONNECT_WITHIN_S;
  }
}
