package org.u2sa.estimation.measurement;

/**
 * Mean difference between a barometer's altitudes and those of receivers. The error of a wrong
 * sea-level pressure lasts for hours, that of a receiver for minutes: their mean difference reveals
 * a barometer that is wrong by several times its claim long before a single pair of altitudes does.
 * The numbers of a barometer are kept in an array, so that a replay reproduces them.
 */
public final class AltitudeDifference {
  /** Numbers of a barometer. */
  public static final int SIZE = 6;

  private static final int NEWEST = 0; // its newest altitude less the estimate [m]
  private static final int NEWEST_MICROS = 1; // 0: none
  private static final int MEAN = 2; // m
  private static final int SECONDS = 3; // over which the mean was taken
  private static final int MICROS = 4; // of the newest comparison
  private static final int CLAIM = 5; // mean claimed variance of the receivers' altitudes [m²]
  private static final double FRESH_S = 1.0;
  private static final double PAUSE_S = 2.0; // longer times between receivers' altitudes count less
  private static final double MEMORY_S = 300.0;
  private static final double NEEDED_S = 10.0;
  private static final double SIGMAS = 3.0;
  private static final double LASTING =
      0.25; // share of a receiver's variance, as of the ionosphere

  private AltitudeDifference() {}

  /**
   * Records an altitude of the barometer.
   *
   * @param at index of the barometer's numbers, initially 0
   * @param apart measured less estimated altitude [m]
   * @param micros time of the estimate [µs]
   */
  public static void barometer(double[] t, int at, double apart, double micros) {
    t[at + NEWEST] = apart;
    t[at + NEWEST_MICROS] = Math.max(1.0, micros);
  }

  /**
   * Compares the newest altitude of the barometer, if it is fresh, with one of a receiver.
   *
   * @param at index of the barometer's numbers
   * @param apart measured less estimated altitude [m]
   * @param claim claimed variance of the measured altitude [m²]
   * @param micros time of the estimate [µs]
   */
  public static void receiver(double[] t, int at, double apart, double claim, double micros) {
    boolean isFresh = (micros - t[at + NEWEST_MICROS]) * 1e-6 < FRESH_S;
    if (t[at + NEWEST_MICROS] == 0.0 || !isFresh) {
      return;
    }
    double seconds = Math.min(PAUSE_S, Math.max(0.0, (micros - t[at + MICROS]) * 1e-6));
    t[at + MICROS] = micros;
    t[at + SECONDS] += seconds;
    double share = seconds / Math.min(MEMORY_S, Math.max(1e-3, t[at + SECONDS]));
    t[at + MEAN] += share * (t[at + NEWEST] - apart - t[at + MEAN]);
    t[at + CLAIM] += share * (claim - t[at + CLAIM]);
  }

  /** Mean of the barometer's less the receivers' altitudes [m]. */
  public static double metres(double[] t, int at) {
    return t[at + MEAN];
  }

  /**
   * Whether the receivers' altitudes show that the barometer claims too much.
   *
   * @param at index of the barometer's numbers
   * @param claim claimed variance of its altitude [m²]
   * @param correlationS correlation time of a receiver's error [s]
   */
  public static boolean isContradicted(double[] t, int at, double claim, double correlationS) {
    double seconds = t[at + SECONDS];
    if (seconds < NEEDED_S) {
      return false;
    }
    // n independent errors have a mean of variance σ²/n; there is one in every 2 τ.
    double averaged = 2.0 * correlationS / Math.min(2.0 * MEMORY_S, seconds);
    double receivers = t[at + CLAIM] * Math.max(LASTING, Math.min(1.0, averaged));
    return t[at + MEAN] * t[at + MEAN] > SIGMAS * SIGMAS * (claim + receivers);
  }
}
