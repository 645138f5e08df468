package org.u2sa.estimation.fusion;

import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;

/**
 * Residual delays of the first {@link FilterState#DELAY_SLOTS} position sources, estimated as
 * filter states (online temporal calibration; Li and Mourikis, IJRR 33(7), 2014): a position fused
 * at time t was measured at t - τ and lags by v τ. Velocity measurements cannot be used to estimate
 * τ: on a vibrating vehicle, samples do not show how much velocity changed in that time.
 *
 * <p>While τ is unobservable, as on a straight at constant speed, the position stays uncertain
 * along track in proportion to the uncertainty of τ; turns and speed changes make it observable if
 * other sensors measure them. Only then is τ corrected. Otherwise its uncertainty is considered
 * (Schmidt 1966), and the model is linearised about a steady velocity: noise in the estimated
 * velocity would be mistaken for information on τ.
 */
final class DelayErrors {
  static final int NONE = -1;

  static final double MAX_S = 0.5; // bounds delays to [0, MAX_S]

  private static final double NOISE = 1e-3; // random walk of a delay, s per √s
  private static final double MIN_S = 0.03; // minimum delay to report
  private static final double SIGMAS = 3.0; // required significance
  private static final double CHANGING_S = 2.0; // time constant of the steady velocity in a change
  private static final double STEADY_S = 30.0; // otherwise
  private static final double MIN_CHANGE_MPS = 0.3; // velocity change that makes τ observable
  private static final double MIN_CHANGE_SHARE = 0.15; // fraction of the steady speed

  private final double sigmaS;

  DelayErrors(FilterTuning tuning) {
    sigmaS = tuning.delaySigmaS();
  }

  /**
   * Slot of the source's delay; assigns a free one at its first position.
   *
   * @return NONE if the quantity is not a position, delays are not estimated, or all slots are
   *     taken
   */
  int slot(FilterState s, SensedQuantity quantity, int source) {
    if (sigmaS <= 0.0 || !quantity.isPlace()) {
      return NONE;
    }
    for (int slot = 0; slot < FilterState.DELAY_SLOTS; slot++) {
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

  /** Returns all delays to their initial uncertainty: wrong speeds have been mistaken for them. */
  static void reopen(FilterState s, FilterTuning tuning) {
    for (int slot = 0; slot < FilterState.DELAY_SLOTS; slot++) {
      if (s.delaySource[slot] != FilterState.NO_SOURCE) {
        s.x[FilterState.DELAYS + slot] = 0.0;
        s.isolate(FilterState.DELAY + slot, tuning.delaySigmaS() * tuning.delaySigmaS());
      }
    }
  }

  /** Correlates the position with the delay after the position was initialised from this source. */
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

  /** Adds the delay to the measurement model: p(t - τ) ≈ p - v τ. */
  static void look(
      FilterState s, Measurement m, SensedQuantity quantity, Linearization model, int slot) {
    if (slot == NONE) {
      return;
    }
    double late = s.x[FilterState.DELAYS + slot];
    int velocity = isObservable(s) ? FilterState.V : FilterState.STEADY_V;
    int row = 0;
    for (int i = 0; i < quantity.size(); i++) {
      if (m.has(quantity, i)) {
        model.innovation[row] += late * s.x[FilterState.V + i];
        model.set(row, FilterState.VELOCITY + i, -late);
        model.set(row, FilterState.DELAY + slot, -s.x[velocity + i]);
        row++;
      }
    }
  }

  /** Whether the vehicle turns or changes its speed, so that positions show how late they are. */
  static boolean isObservable(FilterState s) {
    double north = s.x[FilterState.STEADY_V];
    double east = s.x[FilterState.STEADY_V + 1];
    double change = Math.hypot(s.x[FilterState.V] - north, s.x[FilterState.V + 1] - east);
    double variance = s.variance(FilterState.VELOCITY) + s.variance(FilterState.VELOCITY + 1);
    return (s.isStrapdown || s.hasSpeedInput())
        && change > MIN_CHANGE_MPS
        && change > MIN_CHANGE_SHARE * Math.hypot(north, east)
        && change > SIGMAS * Math.sqrt(variance);
  }

  /** Adds the random-walk noise of the delays, and updates the steady velocity. */
  static void wander(FilterState s, double dt) {
    double share = Math.min(1.0, dt / (isObservable(s) ? CHANGING_S : STEADY_S));
    for (int i = 0; i < 2; i++) {
      s.x[FilterState.STEADY_V + i] +=
          share * (s.x[FilterState.V + i] - s.x[FilterState.STEADY_V + i]);
    }
    for (int slot = 0; slot < FilterState.DELAY_SLOTS; slot++) {
      if (s.delaySource[slot] != FilterState.NO_SOURCE) {
        s.p.data[(FilterState.DELAY + slot) * (FilterState.N + 1)] += NOISE * NOISE * dt;
      }
    }
  }

  /** Clamps a delay to its valid range: estimates outside stem from other errors. */
  static double possible(double seconds) {
    return Math.min(MAX_S, Math.max(0.0, seconds));
  }

  /** Estimated delay of a source [s]; 0 if too small or not significant. */
  static double lateS(FilterState s, int source) {
    for (int slot = 0; slot < FilterState.DELAY_SLOTS; slot++) {
      double late = s.x[FilterState.DELAYS + slot];
      double sigma = Math.sqrt(s.variance(FilterState.DELAY + slot));
      if (s.delaySource[slot] == source && late > Math.max(MIN_S, SIGMAS * sigma)) {
        return late;
      }
    }
    return 0.0;
  }
}
