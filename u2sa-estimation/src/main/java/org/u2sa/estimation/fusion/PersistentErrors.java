package org.u2sa.estimation.fusion;

import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.PositionGrid;
import org.u2sa.estimation.measurement.SensedQuantity;

/**
 * Time-correlated measurement errors as filter states: first-order Gauss-Markov processes (Brown
 * and Hwang, 3rd ed., section 5.3), two for each of the first {@link FilterState#POSITION_SOURCES}
 * position sources, because a receiver's error drifts over minutes, and one for each of the first
 * {@link FilterState#HEADING_SOURCES} heading sources, because a compass's deviation is constant
 * while the vehicle keeps its direction.
 *
 * <p>A single source cannot distinguish its error from the vehicle's motion, so repeated
 * measurements reduce neither uncertainty below the claimed one. But if other sensors measure how
 * the vehicle moved and turned, a drifting error cannot drag the estimate along, and earlier, more
 * accurate knowledge is retained.
 *
 * <p>If wheels measure the motion, they also reveal how much a position source drifts, and its
 * variance is learned by expectation maximisation: the mean of b² + P, estimated error and its
 * variance (Shumway and Stoffer 1982). The learned variance is never below the claim. With
 * multipath, a receiver's error is several times the claimed sigma.
 */
final class PersistentErrors {
  static final int NONE = -1;

  /** White-noise fraction of a claimed sigma. The rest is time-correlated. */
  private static final double NEW_SHARE = 0.2;

  private static final double OUTGROWN = 9.0; // of the variance to the newest claimed variance

  private static final double MEMORY = 4.0; // time constants over which a variance is learned
  private static final double LARGEST = 4.0; // limit of one error, as a multiple of the variance
  static final double NEW_VARIANCE = NEW_SHARE * NEW_SHARE;

  /** Factor on the white variance that makes all of the claimed error white. */
  static final double ALL_WHITE = 1.0 / NEW_VARIANCE;

  private static final double UNIFORM = 12.0; // inverse variance of the uniform distribution

  private final double positionS;
  private final double headingS;

  PersistentErrors(FilterTuning tuning) {
    positionS = tuning.positionCorrelationS();
    headingS = tuning.headingCorrelationS();
  }

  static boolean isPosition(int slot) {
    return slot != NONE && slot < FilterState.POSITION_SOURCES;
  }

  private static int size(int slot) {
    return isPosition(slot) ? 2 : 1;
  }

  /** Index of a slot's first state in the filter's state vector. */
  private static int first(int slot) {
    return isPosition(slot) ? 2 * slot : FilterState.POSITION_SOURCES + slot;
  }

  private double timeConstantS(int slot) {
    return isPosition(slot) ? positionS : headingS;
  }

  /**
   * Slot of the source's error; assigns a free one if necessary.
   *
   * @param at index of the source's quantity in {@link SourceTrust}
   * @return NONE if errors of that quantity are not time-correlated, or all slots are taken
   */
  int slot(FilterState s, Measurement m, SensedQuantity quantity, int source, int at) {
    int from = quantity == SensedQuantity.PLACE ? 0 : FilterState.POSITION_SOURCES;
    int to =
        quantity == SensedQuantity.PLACE
            ? FilterState.POSITION_SOURCES
            : FilterState.PERSISTENT_SLOTS;
    boolean isKind = quantity == SensedQuantity.PLACE || quantity == SensedQuantity.HEADING;
    if (!isKind || timeConstantS(from) <= 0.0) {
      return NONE;
    }
    for (int slot = from; slot < to; slot++) {
      boolean isFree = s.persistentSource[slot] == FilterState.NO_SOURCE;
      if (isFree || s.persistentSource[slot] == source) {
        if (isPosition(slot) && !isFree) {
          learn(s, slot, at);
        }
        if (isPosition(slot)) {
          widen(s, m, slot, at);
        }
        note(s, m, quantity, slot, Math.max(1.0, s.trust[at + SourceTrust.WANDER]));
        if (isFree || isOutgrown(s, slot)) {
          s.persistentSource[slot] = source;
          begin(s, slot);
        }
        return slot;
      }
    }
    return NONE;
  }

  /** Makes errors and position as uncertain as the rounding of the source's coordinates. */
  private static void widen(FilterState s, Measurement m, int slot, int at) {
    SensedQuantity place = SensedQuantity.PLACE;
    if (!m.has(place, 0) || !m.has(place, 1)) {
      return;
    }
    int grid = at + SourceTrust.GRID;
    PositionGrid.record(s.trust, grid, m.value(place, 0), m.value(place, 1));
    double north = PositionGrid.step(s.trust, grid, 0) * s.northRadiusM();
    double east = PositionGrid.step(s.trust, grid, 1) * s.axisDistanceM();
    double rounded = Math.max(north * north, east * east) / UNIFORM;
    double claim = Math.max(m.sigma(place, 0), m.sigma(place, 1));
    double known = claim * claim * Math.max(1.0, s.trust[at + SourceTrust.WANDER]);
    if (rounded > known) {
      s.trust[at + SourceTrust.WANDER] = rounded / (claim * claim);
      unsettle(s, slot, rounded - known);
    }
  }

  /** Adds a variance to both position and error. */
  private static void unsettle(FilterState s, int slot, double variance) {
    for (int i = 0; i < 2; i++) {
      s.p.data[(FilterState.POSITION + i) * (FilterState.N + 1)] += variance;
      s.p.data[(FilterState.PERSISTENT + first(slot) + i) * (FilterState.N + 1)] += variance;
    }
  }

  /** Learns E(b² + P) of the error state, as a multiple of the claimed variance. */
  private void learn(FilterState s, int slot, int at) {
    double[] t = s.trust;
    double seconds = (s.micros - t[at + SourceTrust.WANDER_MICROS]) * 1e-6;
    t[at + SourceTrust.WANDER_MICROS] = s.micros;
    if (!s.hasHeading || !s.hasSpeedInput() || seconds > positionS) {
      return;
    }
    double known = Math.max(1.0, t[at + SourceTrust.WANDER]);
    double shown = 0.0;
    for (int i = first(slot); i < first(slot) + size(slot); i++) {
      double error = s.x[FilterState.PERSISTENT_ERRORS + i];
      shown += (error * error + s.variance(FilterState.PERSISTENT + i)) / size(slot);
    }
    shown *= known / s.x[FilterState.PERSISTENT_VARIANCE + slot];
    double learnt = Math.min(MEMORY * positionS, t[at + SourceTrust.WANDER_S] + seconds);
    double share = seconds / (positionS + learnt); // the claim weighs one time constant
    double before = Math.max(t[at + SourceTrust.WANDER], learnt == seconds ? 1.0 : 0.0);
    t[at + SourceTrust.WANDER_S] = learnt;
    t[at + SourceTrust.WANDER] = before + share * (Math.min(shown, LARGEST * known) - before);
  }

  /**
   * Handles positions that persistently contradict the wheels at a constant offset: either the
   * source's error or the estimate is off by this amount. Increases the uncertainty of both
   * accordingly.
   */
  static void jumped(FilterState s, Linearization model, int slot, int at) {
    double[] n = model.innovation;
    double by = (n[0] * n[0] + n[1] * n[1]) / 2.0;
    double known = Math.max(1.0, s.trust[at + SourceTrust.WANDER]);
    double claimed = s.x[FilterState.PERSISTENT_VARIANCE + slot] / known;
    s.trust[at + SourceTrust.WANDER] = Math.max(known, by / claimed);
    s.trust[at + SourceTrust.STREAK] = 0.0;
    unsettle(s, slot, by);
  }

  private static void note(
      FilterState s, Measurement m, SensedQuantity quantity, int slot, double wander) {
    double claim = 0.0;
    for (int i = 0; i < size(slot); i++) {
      double sigma = m.has(quantity, i) ? m.sigma(quantity, i) : 0.0;
      claim = Math.max(claim, sigma * sigma);
    }
    s.x[FilterState.PERSISTENT_VARIANCE + slot] = (1.0 - NEW_VARIANCE) * claim * wander;
  }

  /** Whether the source claimed a much larger error before, which is now obsolete. */
  private static boolean isOutgrown(FilterState s, int slot) {
    double known = s.variance(FilterState.PERSISTENT + first(slot));
    return known > OUTGROWN * s.x[FilterState.PERSISTENT_VARIANCE + slot];
  }

  private static void begin(FilterState s, int slot) {
    for (int i = first(slot); i < first(slot) + size(slot); i++) {
      s.x[FilterState.PERSISTENT_ERRORS + i] = 0.0;
      s.isolate(FilterState.PERSISTENT + i, s.x[FilterState.PERSISTENT_VARIANCE + slot]);
    }
  }

  /** Correlates the state with the error of the source that initialised the quantity. */
  static void share(FilterState s, int slot) {
    if (slot == NONE) {
      return;
    }
    begin(s, slot);
    int state = isPosition(slot) ? FilterState.POSITION : FilterState.ATTITUDE + 2;
    for (int i = 0; i < size(slot); i++) {
      int error = FilterState.PERSISTENT + first(slot) + i;
      double shared = Math.min(s.variance(error), s.variance(state + i));
      s.p.data[error * FilterState.N + state + i] = -shared;
      s.p.data[(state + i) * FilterState.N + error] = -shared;
    }
  }

  /** Adds the persistent error to the measurement model; the remaining noise is white. */
  static void look(
      FilterState s, Measurement m, SensedQuantity quantity, Linearization model, int slot) {
    if (slot == NONE) {
      return;
    }
    int row = 0;
    for (int i = 0; i < size(slot); i++) {
      if (m.has(quantity, i)) {
        model.set(row, FilterState.PERSISTENT + first(slot) + i, 1.0);
        model.innovation[row] -= s.x[FilterState.PERSISTENT_ERRORS + first(slot) + i];
        model.variance[row] *= NEW_VARIANCE;
        row++;
      }
    }
  }

  /** Decay factor of a slot's states over that time. */
  private double kept(int slot, double dt) {
    double timeConstantS = timeConstantS(slot);
    return timeConstantS > 0.0 ? Math.max(0.0, 1.0 - dt / timeConstantS) : 1.0;
  }

  /** Applies the decay of the errors to state and F. */
  void fade(FilterState s, Transition f, double dt) {
    for (int slot = 0; slot < FilterState.PERSISTENT_SLOTS; slot++) {
      if (s.persistentSource[slot] == FilterState.NO_SOURCE) {
        continue;
      }
      double kept = kept(slot, dt);
      for (int i = first(slot); i < first(slot) + size(slot); i++) {
        s.x[FilterState.PERSISTENT_ERRORS + i] *= kept;
        f.set(FilterState.PERSISTENT + i, FilterState.PERSISTENT + i, kept);
      }
    }
  }

  /** Process noise of a slot's errors, per axis [m²/s]. */
  double wanderRate(FilterState s, int slot) {
    boolean persists = slot != NONE && timeConstantS(slot) > 0.0;
    return persists ? 2.0 * s.x[FilterState.PERSISTENT_VARIANCE + slot] / timeConstantS(slot) : 0.0;
  }

  /** Adds the process noise of the errors: driven by 2 σ² / τ they keep their σ. */
  void wander(FilterState s, double dt) {
    for (int slot = 0; slot < FilterState.PERSISTENT_SLOTS; slot++) {
      if (s.persistentSource[slot] != FilterState.NO_SOURCE) {
        double q = wanderRate(s, slot);
        for (int i = first(slot); i < first(slot) + size(slot); i++) {
          s.p.data[(FilterState.PERSISTENT + i) * (FilterState.N + 1)] += q * dt;
        }
      }
    }
  }
}
