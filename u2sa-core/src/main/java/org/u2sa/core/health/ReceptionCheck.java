package org.u2sa.core.health;

import org.u2sa.messages.contract.HealthReport;

/**
 * Whether the monitor hears anything at all. Its own reports take the same way as all others: if
 * they do not come back, the way is broken and the silence of others means nothing.
 */
final class Hearing {
  private static final double DEAF_AFTER_INTERVALS = 4.0;
  private static final double DEAF_AFTER_AT_LEAST_S = 1.0;

  /** After a broken way: others come back by an attempt that may hang, and a back-off. */
  private static final double OTHERS_ARE_BACK_WITHIN_S = 6.0;

  private double heardS;
  private double deafAfterS = DEAF_AFTER_AT_LEAST_S;
  private boolean wasDeaf;

  Hearing(double nowS) {
    heardS = nowS;
  }

  /** Takes note of a report of the monitor itself. */
  void hear(HealthReport own, double nowS) {
    heardS = nowS;
    deafAfterS = Math.max(DEAF_AFTER_AT_LEAST_S, DEAF_AFTER_INTERVALS * own.interval().orElse(0.0));
  }

  /** What became of it since the last look. */
  enum Change {
    /** Hears, as before. */
    NONE,
    /** Has just become deaf. */
    DEAF,
    /** Still deaf. */
    STILL_DEAF,
    /** Hears again: others have until {@link #excusedUntilS} to be heard too. */
    HEARS_AGAIN
  }

  /** Looks. */
  Change look(double nowS) {
    boolean deaf = nowS - heardS > deafAfterS;
    boolean before = wasDeaf;
    wasDeaf = deaf;
    if (deaf) {
      return before ? Change.STILL_DEAF : Change.DEAF;
    }
    return before ? Change.HEARS_AGAIN : Change.NONE;
  }

  /** Until when nobody is judged by silence, after hearing came back. */
  static double excusedUntilS(double nowS) {
    return nowS + OTHERS_ARE_BACK_WITHIN_S;
  }
}
