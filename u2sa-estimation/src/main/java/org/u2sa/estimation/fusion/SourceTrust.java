package org.u2sa.estimation.fusion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * What the sources have shown of themselves: a few numbers for each source, and for each quantity
 * that it measures. Names and places of the numbers are kept here, the numbers in the {@link
 * FilterState}, so that a replay learns the same again.
 *
 * <p>The true variance of a source is learnt from innovations: consecutive ones differ by 2 (H P Hᵀ
 * + R) on average, and their difference is blind to a constant error, which is another matter
 * (innovation-based adaptive estimation, Mehra 1970; difference as in von Neumann 1941). Only more
 * than the claimed variance is believed, never less.
 */
final class SourceTrust {
  // Of a source.
  static final int LAST_MICROS = 0;
  static final int INTERVAL = 1; // s, running mean
  static final int MESSAGES = 2;
  static final int RUN = 3; // messages with the same values as the one before
  static final int IS_FROZEN = 4;
  static final int INERTIAL = 5; // rates and forces that it measures: 0, 3 or 6
  static final int KEPT = 6; // the values themselves
  static final int RATES_MICROS = KEPT + Measurement.SIZE; // of the newest angular rates
  static final int RATES = RATES_MICROS + 1; // those: three
  static final int RELEASED = RATES + 3; // specific force at the reference point: three
  private static final int SOURCE_SIZE = RELEASED + 3;

  // Of a quantity of a source.
  static final int FACTOR = 0; // true over claimed variance, unbounded estimate
  static final int LEARNT = 1; // innovations that it was learnt from
  static final int PREVIOUS = 2; // innovations before, in claimed sigmas: three
  static final int HAS_PREVIOUS = 5;
  static final int USED = 6;
  static final int GATED = 7;
  static final int STREAK = 8; // gated one after the other
  static final int STREAK_MEAN = 9; // mean innovation of the streak, in claimed sigmas: three
  static final int STREAK_SINCE = 12; // µs
  static final int LAST_USED = 13; // µs
  static final int IS_BIASED = 14;
  static final int PASSED = 15; // in a row, while biased
  static final int RUN_START = 16; // predicted when the values began to stand still: three
  static final int OFFSET = 19; // of a local frame that is not the filter's: three
  static final int HAS_OFFSET = 22;
  static final int NIS = 23; // normalised squared innovation of the newest vector
  static final int RUN_OF = 24; // message at which the run began that RUN_START is of
  static final int STREAK_FIRST = 25; // innovation that began the streak: two
  static final int DISTRUST = 27; // least factor, as dead reckoning contradicts the claim
  static final int RESET_MICROS = 28; // when the estimate last began anew from it; 0: never
  static final int DOUBT_MPS = 29; // by how much positions contradict this speed; 0: not
  static final int DOUBT_MEAN = 30; // mean innovation since: three
  static final int WANDER = 33; // true over claimed variance of its persistent error; 0: unknown
  static final int WANDER_S = 34; // for how long it was learnt
  static final int WANDER_MICROS = 35; // when it was learnt last
  static final int STREAK_NEWEST = 36; // newest innovation of the streak: two
  static final int STREAK_JUMP = 38; // largest change from one of its innovations to the next
  static final int STREAK_STEPS2 = 39; // sum of their squares
  private static final int QUANTITY_SIZE = 40;

  private static final double PRIOR = 10.0; // innovations that the claim is worth
  private static final double LARGEST = 25.0; // multiple of the variance that one innovation shows
  private static final double NOTEWORTHY = 1.4; // a lesser factor is chance
  private static final double HIGHEST = 1e6;
  static final double FORGIVEN = 0.998; // of a distrust that remains with each measurement used
  private static final double MEAN_SHARE = 0.05;

  private final int window;
  private final List<String> names = new ArrayList<>();
  private final List<int[]> places = new ArrayList<>(); // per source: its own, then quantities'
  private int size;

  SourceTrust(int window) {
    this.window = window;
  }

  /** The number of a source, which is registered at its first message. */
  int source(String name) {
    for (int i = 0; i < names.size(); i++) {
      if (names.get(i).equals(name)) {
        return i;
      }
    }
    int[] place = new int[1 + SensedQuantity.count()];
    Arrays.fill(place, -1);
    place[0] = size;
    size += SOURCE_SIZE;
    names.add(name);
    places.add(place);
    return names.size() - 1;
  }

  int sources() {
    return names.size();
  }

  String name(int source) {
    return names.get(source);
  }

  /** Where a source's own numbers begin. */
  int of(FilterState s, int source) {
    reserve(s);
    return places.get(source)[0];
  }

  /** Where the numbers of one of its quantities begin. */
  int of(FilterState s, int source, SensedQuantity quantity) {
    int[] place = places.get(source);
    if (place[1 + quantity.ordinal()] < 0) {
      place[1 + quantity.ordinal()] = size;
      size += QUANTITY_SIZE;
    }
    reserve(s);
    return place[1 + quantity.ordinal()];
  }

  boolean isKnown(int source, SensedQuantity quantity) {
    return places.get(source)[1 + quantity.ordinal()] >= 0;
  }

  private void reserve(FilterState s) {
    if (s.trust.length < size) {
      s.trust = Arrays.copyOf(s.trust, size);
    }
  }

  /** Takes note of a message before its vectors are looked at. */
  void heard(FilterState s, Measurement m, int source) {
    int at = of(s, source);
    double[] t = s.trust;
    double interval = (m.micros() - t[at + LAST_MICROS]) * 1e-6;
    if (t[at + MESSAGES] == 1.0) {
      t[at + INTERVAL] = interval;
    } else if (t[at + MESSAGES] > 1.0) {
      t[at + INTERVAL] += MEAN_SHARE * (interval - t[at + INTERVAL]);
    }
    t[at + LAST_MICROS] = m.micros();
    boolean isSame = t[at + MESSAGES] > 0.0 && m.hasValuesOf(t, at + KEPT);
    t[at + MESSAGES]++;
    t[at + RUN] = isSame ? t[at + RUN] + 1.0 : 0.0;
    if (!isSame) {
      t[at + IS_FROZEN] = 0.0;
      m.keep(t, at + KEPT);
    }
  }

  /** By how much the claimed variance is multiplied: 1 or more. */
  static double factor(FilterState s, int at) {
    double learnt = s.trust[at + LEARNT] == 0.0 ? 1.0 : s.trust[at + FACTOR];
    double shown = Math.max(learnt, s.trust[at + DISTRUST]);
    return shown < NOTEWORTHY ? 1.0 : Math.min(HIGHEST, shown);
  }

  /** Restarts learning from that factor. */
  static void raise(double[] t, int at, double factor) {
    t[at + FACTOR] = factor;
    t[at + LEARNT] = PRIOR;
  }

  /**
   * Learns from an innovation.
   *
   * @param expected variance of each component by the state's own uncertainty
   */
  void learn(FilterState s, int at, MeasurementModel model, double[] expected) {
    double[] t = s.trust;
    if (t[at + LEARNT] == 0.0) {
      t[at + FACTOR] = 1.0;
      t[at + LEARNT] = PRIOR;
    }
    boolean hasPrevious = t[at + HAS_PREVIOUS] == model.rows;
    boolean wasRefused = t[at + STREAK] > 0.0; // then nothing corrected the estimate
    double sum = 0.0;
    for (int i = 0; i < model.rows; i++) {
      double inClaims = model.innovation[i] / Math.sqrt(model.variance[i]);
      double step = inClaims - t[at + PREVIOUS + i];
      double shown = step * step / 2.0 - (wasRefused ? 0.0 : expected[i] / model.variance[i]);
      sum += Math.min(shown, LARGEST * Math.max(1.0, t[at + FACTOR]));
      t[at + PREVIOUS + i] = inClaims;
    }
    t[at + HAS_PREVIOUS] = model.rows;
    if (hasPrevious) {
      t[at + LEARNT] = Math.min(window, t[at + LEARNT] + 1.0);
      t[at + FACTOR] += (sum / model.rows - t[at + FACTOR]) / t[at + LEARNT];
      t[at + FACTOR] = Math.max(0.01, t[at + FACTOR]);
    }
  }

  static void notedNis(FilterState s, int at, double nis) {
    s.trust[at + NIS] = nis;
  }
}
