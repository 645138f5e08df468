package org.u2sa.estimation.fusion;

import java.util.Arrays;

/**
 * By how much later than its time says each of the first {@link #SLOTS} position sources measures,
 * as states of the filter (on-line temporal calibration; Li and Mourikis, IJRR 33(7), 2014): a
 * position that is fused as of t was measured at t - τ, and is short by v τ. Velocities do not
 * teach τ: of a vehicle that shakes, no sample says by how much they changed in that time.
 *
 * <p>While nothing tells τ, as on a straight at constant speed, the position stays uncertain along
 * the way by as much as τ is; turns and changes of speed teach it where other sensors know of them.
 */
final class DelayErrors {
  static final int NONE = -1;
  static final int SLOTS = 3;

  static final double MAX_S = 0.5; // no receiver is later, and none measures ahead of time

  private static final double NOISE = 1e-3; // of a delay, s per √s
  private static final double LEAST_S = 0.03; // worth telling
  private static final double SIGMAS = 3.0; // by which it must be known for that

  private final double sigmaS;

  DelayErrors(FilterTuning tuning) {
    sigmaS = tuning.delaySigmaS();
  }

  /** Of a state that has heard nobody. */
  static int[] nobody() {
    int[] sources = new int[SLOTS];
    Arrays.fill(sources, FilterState.NO_SOURCE);
    return sources;
  }

  private static boolean isPosition(SensedQuantity quantity) {
    return quantity == SensedQuantity.PLACE || quantity == SensedQuantity.LOCAL_PLACE;
  }

  /**
   * Which slot holds the source's delay, from its first position on.
   *
   * @return NONE if the quantity does not tell of it, or all slots are taken
   */
  int slot(FilterState s, SensedQuantity quantity, int source) {
    if (sigmaS <= 0.0 || !isPosition(quantity)) {
      return NONE;
    }
    for (int slot = 0; slot < SLOTS; slot++) {
      if (s.delaySource[slot] == source) {
        return slot;
      }
      if (s.delaySource[slot] == FilterState.NO_SOURCE) {
        s.delaySource[slot] = source;
        s.x[FilterState.DELAYS + slot] = 0.0;
        s.isolate(FilterState.DELAY + slot, sigmaS * sigmaS);
        return slot;
      }
    }
    return NONE;
  }

  /** The state has just taken its position from this source: it is as late. */
  static void share(FilterState s, int slot) {
    if (slot == NONE) {
      return;
    }
    int delay = FilterState.DELAY + slot;
    double variance = s.variance(delay);
    for (int i = 0; i < 2; i++) {
      int position = FilterState.POSITION + i;
      double v = s.x[FilterState.V + i];
      s.p.data[position * (FilterState.N + 1)] += v * v * variance;
      s.p.data[position * FilterState.N + delay] = v * variance;
      s.p.data[delay * FilterState.N + position] = v * variance;
    }
  }

  /** p(t - τ) ≈ p - v τ. */
  static void look(
      FilterState s, Measurement m, SensedQuantity quantity, MeasurementModel model, int slot) {
    if (slot == NONE) {
      return;
    }
    double late = s.x[FilterState.DELAYS + slot];
    int row = 0;
    for (int i = 0; i < quantity.size(); i++) {
      if (m.has(quantity, i)) {
        model.innovation[row] += late * s.x[FilterState.V + i];
        model.add(row, FilterState.VELOCITY + i, -late);
        model.add(row, FilterState.DELAY + slot, -s.x[FilterState.V + i]);
        row++;
      }
    }
  }

  /** Lets the delays wander. */
  static void wander(FilterState s, double dt) {
    for (int slot = 0; slot < SLOTS; slot++) {
      if (s.delaySource[slot] != FilterState.NO_SOURCE) {
        s.p.data[(FilterState.DELAY + slot) * (FilterState.N + 1)] += NOISE * NOISE * dt;
      }
    }
  }

  /** What makes a delay negative, or large, is another error, such as a reflected signal. */
  static double possible(double seconds) {
    return Math.min(MAX_S, Math.max(0.0, seconds));
  }

  /** By how much later a source measures than it says [s], 0 if that is too little or not sure. */
  static double lateS(FilterState s, int source) {
    for (int slot = 0; slot < SLOTS; slot++) {
      double late = s.x[FilterState.DELAYS + slot];
      double sigma = Math.sqrt(s.variance(FilterState.DELAY + slot));
      if (s.delaySource[slot] == source && late > Math.max(LEAST_S, SIGMAS * sigma)) {
        return late;
      }
    }
    return 0.0;
  }
}
