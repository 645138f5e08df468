package org.u2sa.estimation.measurement;

import java.util.Arrays;

/**
 * Constant offset of a rejected barometer or depth gauge from an altitude that other sources show:
 * its running mean, and how far it has been from constant. If the other sources are lost, the gauge
 * still measures changes. The numbers of a source are kept in an array, so that a replay reproduces
 * them.
 */
public final class KnownOffset {
  /** Numbers of a source. */
  public static final int SIZE = 6;

  private static final int COUNT = 0;
  private static final int MEAN = 1; // m
  private static final int SPREAD = 2; // mean square difference from it [m²]
  private static final int REFERENCE = 3; // variance of the altitude it was compared with [m²]
  private static final int MICROS = 4; // when it was compared last
  private static final int ALTITUDE = 5; // at that time [m]
  private static final double KNOWN_AFTER = 8.0; // comparisons
  private static final double MEMORY_S = 10.0; // of the mean
  private static final double STEP_SIGMAS = 4.0; // of a gauge that has jumped again
  private static final double WEATHER_MPS = 5.0 / 3600.0; // change with time, 1 σ
  private static final double LAPSE = 0.03; // per metre of climb: air 9 K off standard, 1 σ

  private KnownOffset() {}

  /**
   * Compares a measured altitude with the known one.
   *
   * @param at index of the source's numbers, initially 0
   * @param offset measured less known altitude [m]
   * @param claim claimed variance of the measured altitude [m²]
   * @param altitude known altitude [m]
   * @param reference variance of the known altitude [m²]
   * @param micros time of the measurement [µs]
   */
  public static void learn(
      double[] t,
      int at,
      double offset,
      double claim,
      double altitude,
      double reference,
      double micros) {
    double apart = offset - t[at + MEAN];
    if (t[at + COUNT] == 0.0 || apart * apart > STEP_SIGMAS * STEP_SIGMAS * claim) {
      forget(t, at);
      apart = 0.0;
      t[at + MEAN] = offset;
    }
    t[at + COUNT]++;
    double seconds = (micros - t[at + MICROS]) * 1e-6;
    double share = Math.max(1.0 / t[at + COUNT], Math.min(1.0, seconds / MEMORY_S));
    t[at + MEAN] += share * apart;
    t[at + SPREAD] += share * (apart * apart - t[at + SPREAD]);
    t[at + REFERENCE] = reference;
    t[at + MICROS] = micros;
    t[at + ALTITUDE] = altitude;
  }

  /** Forgets the offset of a source that agrees again, or has another one. */
  public static void forget(double[] t, int at) {
    Arrays.fill(t, at, at + SIZE, 0.0);
  }

  /** Whether the offset is known. */
  public static boolean isKnown(double[] t, int at) {
    return t[at + COUNT] >= KNOWN_AFTER;
  }

  /** Measured less true altitude [m]. */
  public static double metres(double[] t, int at) {
    return t[at + MEAN];
  }

  /**
   * Variance of an altitude corrected by the offset [m²]: it grows with time, because of the
   * weather, and with the height climbed since, because of the air's temperature.
   *
   * @param altitude present altitude [m]
   * @param micros present time [µs]
   */
  public static double variance(double[] t, int at, double altitude, double micros) {
    double weather = WEATHER_MPS * (micros - t[at + MICROS]) * 1e-6;
    double climb = LAPSE * (altitude - t[at + ALTITUDE]);
    return t[at + REFERENCE] + t[at + SPREAD] + weather * weather + climb * climb;
  }
}
