package org.u2sa.estimation.fusion;

import java.util.Arrays;
import org.u2sa.estimation.delay.MotionDelay;
import org.u2sa.estimation.delay.MotionSince;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.MotionHeading;

/**
 * Residual delays of the first {@link FilterState#DELAY_SLOTS} position sources, estimated as
 * filter states (online temporal calibration; Li and Mourikis, IJRR 33(7), 2014): a position fused
 * at time t was measured at t - τ and lags by v τ. The filter does not estimate τ from single
 * velocities: on a vibrating vehicle, samples do not show how much velocity changed in that time.
 *
 * <p>While τ is unobservable, as on a straight at constant speed, the position stays uncertain
 * along track in proportion to the uncertainty of τ; turns and speed changes make it observable if
 * other sensors measure them. Only then is τ corrected. Otherwise its uncertainty is considered
 * (Schmidt 1966), and the model is linearised about a steady velocity: noise in the estimated
 * velocity would be mistaken for information on τ.
 *
 * <p>If the velocities that come with the positions show over seconds that they are late ({@link
 * MotionDelay}), τ is what they show, its uncertainty is considered, and position, velocity and
 * altitude of that source are compared with the motion at t - τ.
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

  private static final double MIN_APART_S = 0.075; // from the delay assumed
  private static final double SHOWN_SIGMA_S = 0.02; // at least
  private static final double UNSURE_S = 0.08; // sigma of a shown delay that is hardly known
  private static final double UNLIKELY = 4.0; // squared standard deviations
  private static final double MISLED_MPS = 0.3; // 1 σ, by velocities whose delay was unknown
  private static final double MISLED_RAD = 0.03;

  private final double sigmaS;
  private final double forceBiasSigma;
  private final MotionDelay motion = new MotionDelay();
  private final MotionSince since = new MotionSince();
  private final double[] v = new double[3];

  DelayErrors(FilterTuning tuning) {
    sigmaS = tuning.delaySigmaS();
    forceBiasSigma = tuning.forceBiasSigma();
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
        int at = slot * MotionDelay.SIZE;
        Arrays.fill(s.delays, at, at + MotionDelay.SIZE, 0.0); // copies leave free slots out
        return slot;
      }
    }
    return NONE;
  }

  /**
   * Compares the velocity that comes with a position with the inertial path.
   *
   * @return whether the source's delay differs from the one assumed until now
   */
  boolean changes(FilterState s, Measurement m, int source) {
    SensedQuantity velocity = SensedQuantity.VELOCITY;
    boolean isHorizontal = m.has(velocity, 0) && m.has(velocity, 1);
    boolean isComparable = s.isStrapdown && isHorizontal && m.has(SensedQuantity.PLACE);
    int slot = isComparable ? slot(s, SensedQuantity.PLACE, source) : NONE;
    if (slot == NONE) {
      return false;
    }
    for (int i = 0; i < 3; i++) {
      v[i] = m.has(velocity, i) ? m.value(velocity, i) : Double.NaN;
    }
    int at = slot * MotionDelay.SIZE;
    double sigma = Math.max(m.sigma(velocity, 0), m.sigma(velocity, 1));
    motion.velocity(s.delays, at, s.path, s.micros * 1e-6, v, sigma);
    double assumed = s.x[FilterState.DELAYS + slot];
    double mean = MotionDelay.meanS(s.delays, at);
    double variance = MotionDelay.variance(s.delays, at);
    double against = MotionDelay.against(s.delays, at, assumed);
    boolean isRefuted = MotionDelay.refutes(s.delays, at, assumed);
    boolean isApart = Math.abs(mean - assumed) > MIN_APART_S;
    boolean isNone = mean < MIN_S && variance < MIN_S * MIN_S;
    boolean isOther = isApart && !isNone;
    if (!s.isDelayShown[slot] && !(isOther && isRefuted)) {
      MotionHeading.doubt(s.motion, isOther && against > MotionDelay.DOUBTED);
      return false;
    }
    if (isApart) {
      MotionHeading.restart(s.motion);
      widen(s, mean - assumed);
    }
    if (isNone || isApart) {
      s.isolate(FilterState.DELAY + slot, isNone ? sigmaS * sigmaS : variance);
    }
    if (!isNone) {
      rescale(s, FilterState.DELAY + slot, variance + SHOWN_SIGMA_S * SHOWN_SIGMA_S);
    }
    s.x[FilterState.DELAYS + slot] = mean;
    s.isDelayShown[slot] = !isNone;
    MotionHeading.doubt(s.motion, variance > UNSURE_S * UNSURE_S);
    if (isApart) {
      adopt(s, since(s, slot), sigma * sigma, variance);
    }
    return isApart;
  }

  /** Sets the variance of a state and keeps its correlations as far as they are possible. */
  private static void rescale(FilterState s, int state, double variance) {
    double before = s.variance(state);
    double factor = before > 0.0 ? Math.min(1.0, Math.sqrt(variance / before)) : 0.0;
    for (int i = 0; i < FilterState.N; i++) {
      s.p.data[state * FilterState.N + i] *= factor;
      s.p.data[i * FilterState.N + state] *= factor;
    }
    s.p.data[state * (FilterState.N + 1)] = variance;
  }

  /** Makes the motion as uncertain as measurements of an unknown delay may have misled it. */
  private void widen(FilterState s, double seconds) {
    boolean isKnown = since(s, Math.abs(seconds), SHOWN_SIGMA_S);
    for (int i = 0; i < 3; i++) {
      double way = seconds * s.x[FilterState.V + i];
      double change = isKnown ? since.change[i] : 0.0;
      raise(s, FilterState.POSITION + i, way * way);
      raise(s, FilterState.VELOCITY + i, change * change + MISLED_MPS * MISLED_MPS);
      raise(s, FilterState.ATTITUDE + i, i < 2 ? MISLED_RAD * MISLED_RAD : 0.0);
      s.x[FilterState.BF + i] = 0.0;
      s.isolate(FilterState.FORCE_BIAS + i, forceBiasSigma * forceBiasSigma);
    }
  }

  /** Adopts the components of the velocity that a wrong delay has kept away from the estimate. */
  private void adopt(FilterState s, boolean isLate, double claimed, double delayVariance) {
    for (int i = 0; i < 3; i++) {
      double slope = isLate ? since.changeSlope[i] : 0.0;
      double variance = claimed + delayVariance * slope * slope;
      double now = v[i] + (isLate ? since.change[i] : 0.0);
      double apart = now - s.x[FilterState.V + i]; // NaN if not measured
      if (apart * apart > UNLIKELY * (variance + s.variance(FilterState.VELOCITY + i))) {
        Alignment.velocity(s, i, now, variance + MISLED_MPS * MISLED_MPS);
      }
    }
  }

  private static void raise(FilterState s, int state, double by) {
    s.p.data[state * (FilterState.N + 1)] += by;
  }

  private boolean since(FilterState s, double lateS, double sigmaS) {
    return since.look(s.path, s.x, FilterState.Q, FilterState.BF, lateS, sigmaS);
  }

  /** Computes the motion since a late source's measurement; false if it is not shown to be late. */
  private boolean since(FilterState s, int slot) {
    return slot != NONE
        && s.isDelayShown[slot]
        && since(
            s, s.x[FilterState.DELAYS + slot], Math.sqrt(s.variance(FilterState.DELAY + slot)));
  }

  /** Slot of a source whose velocities show that it is late; NONE if they do not. */
  static int shownSlot(FilterState s, int source) {
    for (int slot = 0; slot < FilterState.DELAY_SLOTS; slot++) {
      if (s.isDelayShown[slot] && s.delaySource[slot] == source) {
        return slot;
      }
    }
    return NONE;
  }

  /** Returns delays to their initial uncertainty: wrong speeds have been mistaken for them. */
  static void reopen(FilterState s, FilterTuning tuning) {
    for (int slot = 0; slot < FilterState.DELAY_SLOTS; slot++) {
      if (s.delaySource[slot] != FilterState.NO_SOURCE && !s.isDelayShown[slot]) {
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
  void look(FilterState s, Measurement m, SensedQuantity quantity, Linearization model, int slot) {
    if (slot == NONE) {
      return;
    }
    double late = s.x[FilterState.DELAYS + slot];
    boolean isShown = since(s, slot);
    int velocity = isObservable(s) ? FilterState.V : FilterState.STEADY_V;
    int row = 0;
    for (int i = 0; i < quantity.size(); i++) {
      if (m.has(quantity, i)) {
        double slope = isShown ? s.x[FilterState.V + i] + since.waySlope[i] : s.x[velocity + i];
        model.innovation[row] += late * s.x[FilterState.V + i] + (isShown ? since.way[i] : 0.0);
        model.set(row, FilterState.VELOCITY + i, -late);
        model.set(row, FilterState.DELAY + slot, -slope);
        row++;
      }
    }
  }

  /** Adds the delay of a source that is shown to be late to the model of its altitude. */
  void lookDown(FilterState s, Linearization model, int slot) {
    if (since(s, slot)) {
      double late = s.x[FilterState.DELAYS + slot];
      double down = s.x[FilterState.V + 2];
      model.innovation[0] -= late * down + since.way[2];
      model.set(0, FilterState.VELOCITY + 2, late);
      model.set(0, FilterState.DELAY + slot, down + since.waySlope[2]);
    }
  }

  /** Likewise to the model of its velocity, with errors of tilt and accelerometers since then. */
  void lookAhead(FilterState s, Measurement m, Linearization model, int slot) {
    if (!since(s, slot)) {
      return;
    }
    double late = s.x[FilterState.DELAYS + slot];
    double fall = late * s.gravity();
    int row = 0;
    for (int i = 0; i < 3; i++) {
      if (m.has(SensedQuantity.VELOCITY, i)) {
        int next = (i + 1) % 3;
        int last = (i + 2) % 3;
        model.innovation[row] += since.change[i];
        model.set(row, FilterState.DELAY + slot, -since.changeSlope[i]);
        // [Δv - g τ]× for δθ and R τ for δb, see ProcessModel
        model.set(row, FilterState.ATTITUDE + next, (last == 2 ? fall : 0.0) - since.change[last]);
        model.set(row, FilterState.ATTITUDE + last, since.change[next] - (next == 2 ? fall : 0.0));
        for (int k = 0; k < 3; k++) {
          model.set(row, FilterState.FORCE_BIAS + k, late * since.r[3 * i + k]);
        }
        row++;
      }
    }
  }

  /** Compares a velocity with the heading; one that is late, with the acceleration at its time. */
  void compareHeading(FilterState s, Linearization velocity, int source, int slot) {
    boolean isShown = since(s, slot);
    MotionHeading.velocity(
        s.motion,
        source,
        velocity.predicted[0] + velocity.innovation[0],
        velocity.predicted[1] + velocity.innovation[1],
        Math.max(velocity.variance[0], velocity.variance[1]),
        isShown ? since.change[0] : 0.0,
        isShown ? since.change[1] : 0.0);
  }

  /** Moves a position or altitude that was adopted from a source by the way since its time. */
  void advance(FilterState s, SensedQuantity quantity, int slot) {
    if (!since(s, slot)) {
      return;
    }
    double late = s.x[FilterState.DELAYS + slot];
    if (quantity == SensedQuantity.ALTITUDE) {
      s.move(0.0, 0.0, late * s.x[FilterState.V + 2] + since.way[2]);
    } else if (quantity.isPlace()) {
      double north = late * s.x[FilterState.V] + since.way[0];
      s.move(north, late * s.x[FilterState.V + 1] + since.way[1], 0.0);
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
      if (s.delaySource[slot] != FilterState.NO_SOURCE && !s.isDelayShown[slot]) {
        s.p.data[(FilterState.DELAY + slot) * (FilterState.N + 1)] += NOISE * NOISE * dt;
      }
    }
  }

  /** Whether a correction applies to a delay: not if the velocities show it. */
  static boolean isEstimated(FilterState s, int slot) {
    return s.delaySource[slot] != FilterState.NO_SOURCE && !s.isDelayShown[slot];
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
